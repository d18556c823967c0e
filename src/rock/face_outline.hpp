#pragma once

#include "bit/bit.hpp"
#include "rock/convex_polygon.hpp"

namespace tdbd::rock {

/// Outline of a flat cutter face. Frame F: X the face's outward normal, -Z the exposure direction,
/// as the cutter's frame (thesis: 3.2.2), its origin in the plane of the outline.
struct FaceOutline {
  Pose X_BF;
  ConvexPolygon rim_F;  ///< (Y, Z), m; counter-clockwise seen from the rock ahead
};

/// The cutter's widest circle, through its tip, as a regular polygon inscribed with a corner at the
/// tip; of a worn cutter what the wear flat leaves. Sharp: the rim of the face. Chamfered: the rim
/// of the chamfer, which the whole cutter's cut follows.
FaceOutline face_outline(const bit::Cutter& c, int rim_points);

}  // namespace tdbd::rock
