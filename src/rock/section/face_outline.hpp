#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::rock {

using Vec2 = Eigen::Vector2d;

/// Convex, counter-clockwise, m. Empty interior with fewer than three corners.
using ConvexPolygon = std::vector<Vec2>;

/// The points with n . x <= b. n need not be a unit vector.
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

/// Stores the part of the polygon in a half-plane in `inside`, which must be another polygon.
void clip(const ConvexPolygon& polygon, const HalfPlane& h, ConvexPolygon& inside);

/// The convex hull of points, counter-clockwise. Corners closer than `slack` (m) to its lines are
/// omitted.
ConvexPolygon convex_hull(std::vector<Vec2> points, double slack);

/// Outline of a flat cutter face. Frame F: X is the face's outward normal, -Z points from the bit
/// to the rock, as in the cutter's frame (thesis: 3.2.2). Its origin is in the plane of the
/// outline.
struct FaceOutline {
  Pose X_BF;
  ConvexPolygon rim_F;  ///< (Y, Z), m; counter-clockwise seen from the rock ahead
};

/// Computes the cutter's widest cross-section, the one through its tip, from its parts: the convex
/// hull of their vertices in that plane. For a sharp cutter it is the rim of the face; for a
/// chamfered one the rim of the chamfer, which determines the cut of the whole cutter; for a worn
/// one it includes the wear flat. Parts of other cutters are ignored. Without a part in the plane
/// the rim is empty.
FaceOutline face_outline(const bit::Cutter& c, int index, const std::vector<bit::Part>& parts);

}  // namespace tdbd::rock
