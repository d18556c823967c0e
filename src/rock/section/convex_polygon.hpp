#pragma once

#include <Eigen/Core>
#include <vector>

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

/// The polygon's part in a half-plane goes to `inside`, another one's room.
void clip(const ConvexPolygon& polygon, const HalfPlane& h, ConvexPolygon& inside);

}  // namespace tdbd::rock
