#pragma once

#include <string>
#include <vector>

#include "core/types.hpp"

namespace tdbd::string {

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
