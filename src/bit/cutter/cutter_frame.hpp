#pragma once

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Axial depth of the land inside the chamfer, m: width along the face / tan(angle from the axis).
double land_depth(const Cutter& c);

/// Axial depth of the whole chamfer, m: the land's and that of the chamfer at the rim.
double chamfer_depth(const Cutter& c);

/// The tip in the cutter frame, m: (-chamfer_depth, 0, -D/2), on the outer rim of the chamfer, or
/// on the rim of the face when the edge is sharp.
Vec3 tip_C(const Cutter& c);

/// The tip in the bit frame, m: (r cos phi, r sin phi, -h).
Vec3 tip_B(const Cutter& c);

/// Normal of the bit's profile into the rock at the cutter, bit frame, unit:
/// n = sin(theta) e_r + cos(theta) e_z, with e_r radial at the cutter's azimuth and e_z down.
Vec3 profile_normal_B(const Cutter& c);

/// Places a cutter in the bit frame. Origin: centre of the face. With t the direction of motion,
/// n the profile's normal, b the back rake:
///   X = cos(b) t + sin(b) n,   Z = sin(b) t - cos(b) n,   Y = Z x X;
/// then the side rake turns X and Y about Z. X is the face's outward normal, -Z the exposure
/// direction. The face leans over the rock ahead of it, so the body clears the rock behind the
/// edge. The tip lands on its place in the table exactly. With side rake s the rim's point farthest
/// along n is not quite the tip: it reaches (D/2) (sqrt(cos^2 b + sin^2 s sin^2 b) - cos b)
/// farther, 3 micrometres on a usual bit. Reads every field but X_BC. Thesis: 3.2.2; the signs of X
/// and Y are reconstructed.
Pose cutter_pose(const Cutter& c);

}  // namespace tdbd::bit
