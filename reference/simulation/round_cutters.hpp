#pragma once

#include <string>
#include <vector>

#include "core/types.hpp"

namespace tdbd::reference {

/// A round cutter of a layout: the outline of its outer rim, a regular polygon whose corner 0 is
/// the tip, in the plane F through the rim. X of F is the face's normal in the direction of motion;
/// -Z points into the rock.
struct RoundCutter {
  Pose X_BF;                     ///< origin: the middle of the rim
  Vec3 normal_B = Vec3::Zero();  ///< unit, of the profile, into the rock
  double radius = 0.0;           ///< m, of the rim's corners
  int corners = 64;              ///< of the rim
  double chamfer_depth = 0.0;    ///< m, along the axis
  double chamfer_width = 0.0;    ///< m, along the face
};

/// Reads a layout (CSV with the columns of cases/bits/bit-b.csv) and derives the frames
/// independently from its angles, bit (1). `chamfer`: m, at `chamfer_angle` (rad) from the cutter's
/// axis.
std::vector<RoundCutter> read_round_cutters(const std::string& path, double chamfer,
                                            double chamfer_angle, int corners);

/// Distance of the polygonal rim from its middle at the angle a (rad) from -Z, m.
double rim_radius(const RoundCutter& cutter, double a);

/// The point of the outline at the angle a from -Z towards Y, moved up the face by `up` (m), frame
/// B.
Vec3 rim_point(const RoundCutter& cutter, double a, double up);

}  // namespace tdbd::reference
