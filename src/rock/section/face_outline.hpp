#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::rock {

using Vec2 = Eigen::Vector2d;

/// Convex, counter-clockwise, m; fewer than three corners enclose nothing.
using ConvexPolygon = std::vector<Vec2>;

/// The points with n . x <= b; n needs no length.
struct HalfPlane {
  Vec2 n;
  double b;
};

/// Area and first moment: the centroid is moment / area.
struct PolygonMoments {
  double area = 0.0;           ///< m2
  Vec2 moment = Vec2::Zero();  ///< m3
};

PolygonMoments moments(const ConvexPolygon& polygon);

/// Writes the part of the polygon in a half-plane to `inside`, which must be another polygon.
void clip(const ConvexPolygon& polygon, const HalfPlane& h, ConvexPolygon& inside);

/// The convex hull of points, counter-clockwise, without corners nearer to its lines than `slack` (m).
ConvexPolygon convex_hull(std::vector<Vec2> points, double slack);

/// Outline of a flat cutter face. Frame F: X the face's outward normal, -Z from the bit towards the
/// rock, as in the cutter's frame (thesis: 3.2.2), its origin in the plane of the outline.
struct FaceOutline {
  Pose X_BF;
  ConvexPolygon rim_F;  ///< (Y, Z), m; counter-clockwise seen from the rock ahead
};

/// The cutter's widest cross-section, that through its tip, from its parts: the convex hull of
/// their vertices in that plane. Sharp: the rim of the face. Chamfered: the rim of the chamfer,
/// which the whole cutter's cut follows. Worn: with the wear flat. Parts of other cutters are
/// ignored; without a part in the plane the rim is empty.
FaceOutline face_outline(const bit::Cutter& c, int index, const std::vector<bit::Part>& parts);

}  // namespace tdbd::rock
