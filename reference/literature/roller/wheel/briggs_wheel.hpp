#pragma once

#include <vector>

namespace tdbd::reference {

/// Briggs's sprocket: equal wedges around an axle, thesis 2.2. Flanks end where they meet those of
/// the next tooth.
struct Sprocket {
  double radius = 0.0;      ///< R, m, of the tips
  int teeth = 0;            ///< at least 3
  double half_angle = 0.0;  ///< b, rad, of a tooth
  double width = 0.0;       ///< L, m
};

/// A smooth wheel: a polygon with this number of sides n, whose corners are wedges of 90 degrees
/// minus pi/n.
Sprocket smooth_wheel(double radius, int sides, double width);

/// Options for rolling a wheel. A pitch is the distance from tooth to tooth.
struct RollingOptions {
  double column = 0.01e-3;  ///< m, of the rock's profile
  double step = 0.08e-3;    ///< m, along the path; at least 4 steps per pitch
  double distance = 0.1;    ///< m, measured, rounded up to whole pitches
};

/// Smallest penetration of a rolled wheel, in columns; with less, the torque is not accurate
/// enough.
inline constexpr int least_columns = 5;

/// Loads on the axle of a rolling wheel, means over the measured distance. Forces of the rock on
/// the wheel: load up, drag against the motion; torque about the axle, > 0 if the rock accelerates
/// the wheel.
struct Rolling {
  double load = 0.0, least_load = 0.0, most_load = 0.0;  ///< N
  double drag = 0.0;                                     ///< N
  double axle_torque = 0.0;                              ///< N m
  double distance = 0.0;                                 ///< m, measured
  /// rad, rotation over the measured distance
  double angle = 0.0;
  double removed_area = 0.0;         ///< m2, of the rock's profile
  std::vector<double> loads, drags;  ///< N, of every measured step
  std::vector<double> profile;       ///< m, depth of the craters, per column

  /// Mean depth (m) of the rock removed by one passage.
  double removed_height() const { return removed_area / distance; }
};

/// Rolls a wheel over flat virgin rock, with its tips at their lowest `penetration` (m) below the
/// rock's surface, forward by `rolling_radius` (m) per radian. The pressure (Pa) acts on a flank
/// where it lies in rock and moves into it; the rock keeps the craters. Measurement begins when
/// craters repeat. Reconstructed. Energy, exact for small steps: drag x distance - axle torque x
/// angle = pressure x width x removed area. Throws InputError for fewer than 3 teeth, a penetration
/// of less than five columns or beyond the radius, teeth so sharp that they undercut (half-angle
/// smaller than that of the arc in the rock), or so blunt that they are not teeth.
void roll(const Sprocket& wheel, double pressure, double penetration, double rolling_radius,
          const RollingOptions& options, Rolling& result);

/// The rolling radius (m) at which the mean axle torque is 0, so that only the rock turns the
/// wheel. Independent of the pressure. Throws InputError as roll does, or if the torque has the
/// same sign from 0.9 to 1.1 R.
double free_rolling_radius(const Sprocket& wheel, double penetration,
                           const RollingOptions& options);

}  // namespace tdbd::reference
