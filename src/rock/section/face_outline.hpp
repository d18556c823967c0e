#pragma once

#include "bit/bit.hpp"
#include "rock/section/convex_polygon.hpp"

namespace tdbd::rock {

/// Outline of a flat cutter face. Frame F: X the face's outward normal, -Z the exposure direction,
/// as the cutter's frame (thesis: 3.2.2), its origin in the plane of the outline.
struct FaceOutline {
  Pose X_BF;
  ConvexPolygon rim_F;  ///< (Y, Z), m; counter-clockwise seen from the rock ahead
};

/// The cutter's widest cross-section, that through its tip, as its parts have it: the convex hull
/// of their vertices in that plane. Sharp: the rim of the face. Chamfered: the rim of the chamfer,
/// which the whole cutter's cut follows. Worn: with the wear flat. Parts of other cutters are
/// passed over; without a part in the plane the rim is empty.
FaceOutline face_outline(const bit::Cutter& c, int index, const std::vector<bit::Part>& parts);

}  // namespace tdbd::rock
