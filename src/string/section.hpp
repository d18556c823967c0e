#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tdbd::string {

struct Material {
  double young = 206e9;     ///< Pa
  double shear = 79.3e9;    ///< Pa
  double density = 7850.0;  ///< kg/m3
};

/// A length of pipe or collars with the same properties all along, as a soft string has them.
struct Section {
  double length = 0.0;              ///< m
  double axial_rigidity = 0.0;      ///< E A, N
  double torsional_rigidity = 0.0;  ///< G J, N m2
  double mass = 0.0;                ///< rho A, kg/m
  double inertia = 0.0;             ///< rho J, kg m
  double weight = 0.0;              ///< in mud, N/m
  double contact_radius = 0.0;      ///< where it touches the hole, m
  double bending_rigidity = 0.0;    ///< E I, N m2: for warnings alone
};

/// Diameters of a pipe, m.
struct Diameters {
  double outer = 0.0;
  double inner = 0.0;
  double contact = 0.0;  ///< of the tool joints
};

/// What surrounds the string.
struct Surroundings {
  double mud_density = 0.0;  ///< kg/m3
  double gravity = 9.80665;  ///< m/s2
};

/// A pipe. `linear_mass` (kg/m, with tool joints) takes the place of rho A where it is positive:
/// for mass, weight and, in proportion, rotational inertia.
Section pipe(double length, const Diameters& diameters, const Material& material,
             double linear_mass, const Surroundings& surroundings);

/// A string cut into n elements of equal length: stiffnesses of elements in series, masses of the
/// cells around nodes, so that sections may end anywhere (string (1)).
struct Elements {
  double length = 0.0;                   ///< of an element, m
  std::vector<double> axial, torsional;  ///< stiffnesses of n elements, N/m, N m/rad
  std::vector<double> mass, inertia;     ///< of n + 1 cells, kg, kg m2
};

double total_length(const std::vector<Section>& sections);

/// `count` elements from the surface to the bit; at least one.
Elements make_elements(const std::vector<Section>& sections, int count);

/// An interval of one section, m from the surface.
struct Span {
  double top = 0.0, bottom = 0.0;
  const Section* section = nullptr;
};

/// The parts of sections between two depths, downward.
std::vector<Span> spans_between(const std::vector<Section>& sections, double top, double bottom);

/// Z = J sqrt(G rho): torque over speed of a torsional wave, N m s/rad.
double torsional_impedance(const Section& section);

/// Speeds of waves along a section, m/s.
double axial_wave_speed(const Section& section);
double torsional_wave_speed(const Section& section);

}  // namespace tdbd::string
