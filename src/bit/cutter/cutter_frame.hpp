#pragma once

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Axial depth of the land inside the chamfer, m: width along the face / tan(angle from the axis).
double land_depth(const Cutter& c);

/// Axial depth of the whole chamfer, m: the depths of the land and of the chamfer at the rim.
double chamfer_depth(const Cutter& c);

/// The tip in the cutter frame, m: (-chamfer_depth, 0, -D/2), on the outer rim of the chamfer, or
/// on the rim of the face if the edge is sharp.
Vec3 tip_C(const Cutter& c);

/// The tip in the bit frame, m: (r cos phi, r sin phi, -h).
Vec3 tip_B(const Cutter& c);

/// Unit direction in which the tip moves as the bit rotates, in the bit frame.
Vec3 direction_of_motion_B(const Cutter& c);

/// Unit normal of the bit's profile into the rock at the cutter, in the bit frame: n = sin(theta)
/// e_r + cos(theta) e_z, with e_r radial at the cutter's azimuth and e_z down.
Vec3 profile_normal_B(const Cutter& c);

/// Computes the pose of a cutter in the bit frame, bit (1). Origin: centre of the face. X is the
/// face's outward normal; -Z lies in the face and points from the bit to the rock. The face leans
/// over the rock ahead of it, so the body clears the rock behind the edge. The tip is exactly at
/// its place in the table. With side rake s, the point of the rim farthest along the profile's
/// normal is not quite the tip: it reaches (D/2) (sqrt(cos^2 b + sin^2 s sin^2 b) - cos b) farther,
/// 3 micrometres on a usual bit, with b the back rake and D the diameter. Reads every field except
/// X_BC. Thesis: 3.2.2 (origin) and 4.1.2.1 (the negative of Z is projected). X and Y are
/// reconstructed because page 23 is missing.
Pose cutter_pose(const Cutter& c);

}  // namespace tdbd::bit
