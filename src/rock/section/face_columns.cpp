#include "rock/section/face_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tdbd::rock {
namespace {

constexpr double farthest = std::numeric_limits<double>::max();

/// Corners whose y differ by less, relative to the outline's width, share the end of a column.
constexpr double same_y = 1e-12;

void find_box(const ConvexPolygon& outline_F, FaceColumns& c) {
  c.lo_F = Vec2::Constant(farthest);
  c.hi_F = Vec2::Constant(-farthest);
  for (const Vec2& x_F : outline_F) {
    c.lo_F = c.lo_F.cwiseMin(x_F);
    c.hi_F = c.hi_F.cwiseMax(x_F);
  }
}

/// Makes empty columns between the corners' y.
void divide_at_corners(const ConvexPolygon& outline_F, FaceColumns& c) {
  c.columns.clear();
  c.columns.reserve(outline_F.size());
  for (const Vec2& x_F : outline_F) c.columns.push_back({x_F.x(), 0, 0, 0, 0, 0, 0, 0, 1, {}});
  std::ranges::sort(c.columns, {}, &FaceColumn::y0);
  const double width = c.hi_F.x() - c.lo_F.x();
  const auto same = [&](const FaceColumn& a, const FaceColumn& b) {
    return b.y0 - a.y0 <= same_y * width;
  };
  c.columns.erase(std::unique(c.columns.begin(), c.columns.end(), same), c.columns.end());
  for (std::size_t i = 0; i + 1 < c.columns.size(); ++i) c.columns[i].y1 = c.columns[i + 1].y0;
  c.columns.pop_back();
}

bool lies_on(const HalfPlane& h, const Vec2& p, const Vec2& q, double size) {
  const double slack = same_y * size * h.n.norm();
  return std::abs(h.n.dot(p) - h.b) <= slack && std::abs(h.n.dot(q) - h.b) <= slack;
}

/// Writes the edge from p to q into the columns that it spans. It is a lower edge if it runs to the
/// right.
void add_edge_to_columns(const Vec2& p, const Vec2& q, bool is_rim, FaceColumns& c) {
  const bool lower = p.x() < q.x();
  const Vec2 &left = lower ? p : q, &right = lower ? q : p;
  const double slope = (right.y() - left.y()) / (right.x() - left.x());
  const double rise = std::sqrt(1.0 + slope * slope), length = is_rim ? rise : 0.0;
  for (FaceColumn& column : c.columns) {
    const double middle = 0.5 * (column.y0 + column.y1);
    if (middle < left.x() || middle > right.x()) continue;
    const double z = left.y() + slope * (column.y0 - left.x());
    (lower ? column.lower : column.upper) = z;
    (lower ? column.lower_slope : column.upper_slope) = slope;
    (lower ? column.lower_length : column.upper_length) = length;
    if (lower) column.lower_rise = rise;
  }
}

void sum_below_lower_edge(FaceColumns& made) {
  PolygonMoments sum;
  for (FaceColumn& c : made.columns) {
    c.below = sum;
    sum = made.below_lower_edge(c, c.y1);
  }
}

void index_columns(FaceColumns& c) {
  c.parts_per_metre = static_cast<double>(c.first_of.size()) / (c.hi_F.x() - c.lo_F.x());
  std::size_t i = 0;
  for (std::size_t k = 0; k < c.first_of.size(); ++k) {
    const double y = c.lo_F.x() + static_cast<double>(k) / c.parts_per_metre;
    while (i + 1 < c.columns.size() && c.columns[i].y1 <= y) ++i;
    c.first_of[k] = static_cast<std::uint16_t>(i);
  }
}

/// The circle about the centroid that touches the nearest edge, reduced by rounding. It is limited
/// in y because a column whose left neighbour is narrower than one part of the width may be two
/// columns from the one returned by FaceColumns::near.
void find_inner_circle(const ConvexPolygon& outline_F, FaceColumns& made) {
  constexpr double rounding = 1e-9;
  const PolygonMoments m = moments(outline_F);
  const Vec2 centre_F = m.moment / m.area;
  double radius = farthest;
  for (std::size_t i = 0; i < outline_F.size(); ++i) {
    const Vec2 &p = outline_F[i], &q = outline_F[i + 1 < outline_F.size() ? i + 1 : 0];
    const Vec2 along = q - p, out = centre_F - p;
    if (along.norm() > 0.0)
      radius = std::min(radius, (along.x() * out.y() - along.y() * out.x()) / along.norm());
  }
  const auto is_wide = [&](std::size_t i) {
    const FaceColumn& c = made.columns[i];
    return (c.y1 - c.y0) * made.parts_per_metre >= 1.0 + rounding;
  };
  const std::size_t middle = made.holding(centre_F.x());
  std::size_t left = middle, right = middle;
  while (left > 0 && is_wide(left - 1)) --left;
  while (right + 1 < made.columns.size() && is_wide(right)) ++right;
  made.inner = {centre_F, radius > 0.0 ? (1.0 - rounding) * radius * radius : -1.0,
                left == 0 ? made.columns[left].y0 : made.columns[left].y1, made.columns[right].y1};
}

}  // namespace

void make_columns(const ConvexPolygon& outline_F, const HalfPlane* cut, FaceColumns& made) {
  made.columns.clear();
  if (outline_F.size() < 3) return;
  find_box(outline_F, made);
  const Vec2 size = made.hi_F - made.lo_F;
  if (!(size.minCoeff() > 0.0)) return;
  divide_at_corners(outline_F, made);
  made.left_is_rim = made.right_is_rim = true;
  for (std::size_t i = 0; i < outline_F.size(); ++i) {
    const Vec2 &p = outline_F[i], &q = outline_F[i + 1 < outline_F.size() ? i + 1 : 0];
    const bool is_rim = cut == nullptr || !lies_on(*cut, p, q, size.norm());
    if (std::abs(p.x() - q.x()) > same_y * size.x())
      add_edge_to_columns(p, q, is_rim, made);
    else
      (p.y() > q.y() ? made.left_is_rim : made.right_is_rim) = is_rim;
  }
  index_columns(made);
  made.inner = {};
  if (cut == nullptr) find_inner_circle(outline_F, made);
  sum_below_lower_edge(made);
}

}  // namespace tdbd::rock
