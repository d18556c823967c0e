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

/// A smooth wheel: a polygon of this many sides, whose corners are wedges of 90 degrees less pi/n.
Sprocket smooth_wheel(double radius, int sides, double width);

/// How a wheel is rolled. A pitch is the way from tooth to tooth.
struct RollingOptions {
  double column = 0.01e-3;  ///< m, of the rock's profile
  double step = 0.08e-3;    ///< m, of the way; at least 4 steps a pitch
  double distance = 0.1;    ///< m, that is measured, rounded up to whole pitches
};

/// Columns in the least penetration that a wheel is rolled at: a contact of less has no torque to weigh.
inline constexpr int least_columns = 5;

/// What the axle of a rolling wheel feels, means over the measured way. Forces of the rock on the wheel:
/// load up, drag against the motion; torque about the axle, > 0 where the rock would turn the wheel
/// faster.
struct Rolling {
  double load = 0.0, least_load = 0.0, most_load = 0.0;  ///< N
  double drag = 0.0;                                     ///< N
  double axle_torque = 0.0;                              ///< N m
  double distance = 0.0;                                 ///< m, measured
  double angle = 0.0;                                    ///< rad, turned meanwhile
  double removed_area = 0.0;                             ///< m2, of the rock's profile
  std::vector<double> loads, drags;                      ///< N, of every measured step
  std::vector<double> profile;  ///< m, depth of the craters in every column

  /// Mean depth (m) that one passage takes off the rock.
  double removed_height() const { return removed_area / distance; }
};

/// Rolls a wheel over flat virgin rock, its tips `penetration` (m) below the rock's face at their lowest,
/// forward `rolling_radius` (m) a radian. A flank feels the pressure (Pa) where it lies in rock and
/// moves into it; the rock keeps the craters. Until craters repeat nothing is measured. Reconstructed.
/// Energy, exact for small steps: drag x distance - axle torque x angle = pressure x width x removed
/// area. Throws InputError: fewer than 3 teeth, a penetration of less than five columns or beyond the radius, teeth so
/// sharp that they undercut (half-angle below that of the arc in the rock) or so blunt that they are none.
void roll(const Sprocket& wheel, double pressure, double penetration, double rolling_radius,
          const RollingOptions& options, Rolling& result);

/// The rolling radius (m) at which the rock turns the wheel and nothing else does: mean axle torque 0.
/// The pressure plays no part. Throws InputError as roll does, or if the torque has one sign from 0.9 to
/// 1.1 R.
double free_rolling_radius(const Sprocket& wheel, double penetration,
                           const RollingOptions& options);

}  // namespace tdbd::reference
