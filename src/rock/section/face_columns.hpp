#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bit/bit.hpp"
#include "rotation/screw.hpp"

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

/// X . v on the face: an affine function in its plane.
struct ForwardSpeed {
  double at_origin;  ///< m/s
  Vec2 gradient;     ///< 1/s

  double operator()(const Vec2& x_F) const { return at_origin + gradient.dot(x_F); }
};

/// Over a face, m/s.
struct SpeedRange {
  double slowest, fastest;
};

ForwardSpeed forward_speed(const Pose& X_BF, const rotation::Twist& twist);

/// Columns of a face, `first` to before `end`, that are carried ahead together.
struct FaceStrip {
  std::size_t first, end;
  double ahead;  ///< s, time for which they are carried
};

/// Divides a face into strips so that the smallest speeds X . v of a strip's columns are within a
/// factor of 1.5. A strip is carried for the time lead / (its smallest speed), so that every point
/// of it moves at least `lead` (m) ahead, but for at most `longest_time` (s). Without a lead it is
/// not carried. No point of the face may move backwards, and at least one must move forwards.
void face_strips(const FaceColumns& face, const ForwardSpeed& v, const SpeedRange& range,
                 double lead, double longest_time, std::vector<FaceStrip>& strips);

/// The time in which the bit turns by `turn` (rad), s; infinite if it does not turn.
double time_of_turn(const rotation::Twist& twist, double turn);

/// The wear flat of a cutter behind the plane of its outline (FaceOutline), divided into strips
/// along the motion of the flat. Not in the thesis. Every strip begins on the straight edge between
/// the flat and the outline. It meets the rock that this point of the edge met, so the strip bears
/// where the edge is in rock. No columns if the cutter has no flat.
struct FlatBehind {
  FaceColumns columns;           ///< (y of the edge in F, distance behind it along the motion), m
  Vec2 edge_F = Vec2::Zero();    ///< z of the edge over y: m at y = 0, and slope
  Vec3 motion_F = Vec3::Zero();  ///< unit vector of the motion, in the flat
  double width = 0.0;            ///< width of a strip across the motion over its dy
};

/// Computes the flat from the parts of a cutter, worn according to Cutter::wear. `index`: of the
/// cutter, as in Part::cutter.
FlatBehind flat_behind(const bit::Cutter& c, int index, const FaceOutline& outline,
                       const std::vector<bit::Part>& parts);

/// A part of a flat.
struct FlatPiece {
  double area = 0.0;             ///< m2
  Vec3 moment_F = Vec3::Zero();  ///< m3: the centroid is moment / area
};

/// The strips that begin between y0 and y1 (m, y0 <= y1) on the edge. Exact for the mesh.
FlatPiece flat_between(const FlatBehind& flat, double y0, double y1);

}  // namespace tdbd::rock
