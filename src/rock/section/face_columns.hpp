#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rock/section/face_outline.hpp"

namespace tdbd::rock {

/// The part of a convex outline between the y of adjacent corners: a trapezoid with a lower and an
/// upper edge. Frame F, m.
struct FaceColumn {
  double y0, y1;                      ///< from left to right
  double lower, lower_slope;          ///< z of the lower edge at y0; dz / dy
  double upper, upper_slope;          ///< z of the upper edge at y0; dz / dy
  double lower_length, upper_length;  ///< of the edge over dy; 0 if this edge is a cut, not the rim
  double lower_rise;                  ///< length of the lower edge over dy, rim or cut
  PolygonMoments below;               ///< of the region between bottom and lower edge, left of y0
};

/// Moments of the trapezoid between z = bottom and the line from p to q, with the sign of y_q -
/// y_p.
inline PolygonMoments below_line(double bottom, const Vec2& p, const Vec2& q) {
  const double h0 = p.y() - bottom, h1 = q.y() - bottom, sum = h0 + h1, width = q.x() - p.x();
  const double y_sum = p.x() * (sum + h0) + q.x() * (sum + h1),
               z_sum = 3.0 * bottom * sum + h0 * h0 + h0 * h1 + h1 * h1;
  return {0.5 * width * sum, width / 6.0 * Vec2(y_sum, z_sum)};
}

/// A circle inside an outline, and the range of y in which a point lies in the column returned by
/// FaceColumns::near or in the next one. In that range no column is narrower than one of the 64
/// parts of the width.
struct InnerCircle {
  Vec2 centre_F = Vec2::Zero();
  double radius2 = -1.0;  ///< m2; negative: no circle
  double left = 0.0, right = 0.0;
};

inline bool contains(const InnerCircle& c, const Vec2& x_F) {
  return (x_F - c.centre_F).squaredNorm() < c.radius2 && x_F.x() > c.left && x_F.x() < c.right;
}

/// An outline in columns, prepared for sums over segments (section.hpp).
struct FaceColumns {
  std::vector<FaceColumn> columns;                ///< in ascending y; empty for an empty outline
  Vec2 lo_F = Vec2::Zero(), hi_F = Vec2::Zero();  ///< m, bounding box
  bool left_is_rim = false,
       right_is_rim = false;  ///< for the vertical edges at the ends, if there are any
  /// Start of the search for a y: columns[first_of[k]] contains the start of the k-th of 64 equal
  /// parts of the width.
  std::array<std::uint16_t, 64> first_of{};
  double parts_per_metre = 0.0;
  InnerCircle inner;  ///< no circle in an outline with a cut

  /// The index of a column that begins at or left of y. y must be in or near the outline's width.
  std::size_t near(double y) const {
    const double part = (y - lo_F.x()) * parts_per_metre;
    return first_of[part < 63.0 ? at(static_cast<int>(part)) : 63];
  }

  /// The index of the column that contains y. y must be in the outline's width.
  std::size_t holding(double y) const {
    std::size_t i = near(y);
    while (i + 1 < columns.size() && columns[i].y1 <= y) ++i;
    return i;
  }

  /// Moments of the region between the box's bottom and the lower edge, left of y, which is in
  /// column c.
  PolygonMoments below_lower_edge(const FaceColumn& c, double y) const {
    const PolygonMoments own =
        below_line(lo_F.y(), {c.y0, c.lower}, {y, c.lower + c.lower_slope * (y - c.y0)});
    return {c.below.area + own.area, c.below.moment + own.moment};
  }
};

/// Computes the columns of a convex, counter-clockwise outline. Edges along the line `cut` (n . x =
/// b), if given, do not count as rim. Reuses the memory of `made`.
void make_columns(const ConvexPolygon& outline_F, const HalfPlane* cut, FaceColumns& made);

}  // namespace tdbd::rock
