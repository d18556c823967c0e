#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/types.hpp"

namespace tdbd::string {

struct Material {
  double young = 206e9;     ///< Pa
  double shear = 79.3e9;    ///< Pa
  double density = 7850.0;  ///< kg/m3
};

/// A length of pipe or collars with uniform properties, for a soft-string model.
struct Section {
  double length = 0.0;              ///< m
  double axial_rigidity = 0.0;      ///< E A, N
  double torsional_rigidity = 0.0;  ///< G J, N m2
  double mass = 0.0;                ///< rho A, kg/m
  double inertia = 0.0;             ///< rho J, kg m
  double weight = 0.0;              ///< in mud, N/m
  double contact_radius = 0.0;      ///< radius at which it touches the hole, m
  double bending_rigidity = 0.0;    ///< E I, N m2: only for warnings
};

/// Diameters of a pipe, m.
struct Diameters {
  double outer = 0.0;
  double inner = 0.0;
  double contact = 0.0;  ///< of the tool joints
};

/// The surroundings of the string.
struct Surroundings {
  double mud_density = 0.0;  ///< kg/m3
  double gravity = 9.80665;  ///< m/s2
};

/// Creates a pipe. A positive `linear_mass` (kg/m, with tool joints) replaces rho A for mass,
/// weight and, proportionally, rotational inertia.
Section pipe(double length, const Diameters& diameters, const Material& material,
             double linear_mass, const Surroundings& surroundings);

/// A string divided into n elements of equal length: stiffnesses of sections in series, masses of
/// the cells around nodes. Sections may therefore end anywhere (string (1)).
struct Elements {
  double length = 0.0;                   ///< of an element, m
  std::vector<double> axial, torsional;  ///< stiffnesses of n elements, N/m, N m/rad
  std::vector<double> mass, inertia;     ///< of n + 1 cells, kg, kg m2
};

double total_length(const std::vector<Section>& sections);

/// Divides a string into `count` >= 1 elements from the surface to the bit.
Elements make_elements(const std::vector<Section>& sections, int count);

/// An interval of one section, m from the surface.
struct Span {
  double top = 0.0, bottom = 0.0;
  const Section* section = nullptr;
};

/// The parts of sections between two depths, downward.
std::vector<Span> spans_between(const std::vector<Section>& sections, double top, double bottom);

/// Z = J sqrt(G rho): ratio of torque to speed of a torsional wave, N m s/rad.
double torsional_impedance(const Section& section);

/// Wave speeds along a section, m/s.
double axial_wave_speed(const Section& section);
double torsional_wave_speed(const Section& section);

/// The path of a well by the minimum curvature method: circular arcs between stations, straight
/// beyond the last one. Frame: x north, y east, z down, origin at the surface.
struct Survey {
  /// The arc from a station to the next: t(s) = cos(k s) t + sin(k s) n.
  struct Arc {
    double depth = 0.0;      ///< measured depth of the upper station, m
    double curvature = 0.0;  ///< 1/m
    Vec3 tangent = Vec3::UnitZ();
    Vec3 normal = Vec3::Zero();  ///< direction of the bend; zero if straight
    Vec3 position = Vec3::Zero();
  };
  std::vector<Arc> arcs;  ///< one per station
};

/// Stations of a survey: measured depth (m, ascending from 0), inclination from the vertical and
/// azimuth from north (rad).
struct Stations {
  std::vector<double> depths, inclinations, azimuths;
};

/// Why these are not a valid survey, with the station; empty if they are.
std::string survey_problem(const Stations& stations);

/// The largest dogleg severity between two stations (counted from 1), rad/m.
struct Dogleg {
  int station = 0;  ///< the lower one
  double severity = 0.0;
};
Dogleg worst_dogleg(const Stations& stations);

/// Creates a survey. Throws InputError with the result of survey_problem.
Survey make_survey(const Stations& stations);

/// A vertical well.
Survey vertical();

Vec3 tangent_at(const Survey& survey, double depth);   ///< unit, at a measured depth (m)
Vec3 position_at(const Survey& survey, double depth);  ///< m, at a measured depth (m)

}  // namespace tdbd::string
