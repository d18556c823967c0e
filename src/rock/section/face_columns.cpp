#include "rock/section/face_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bit/cutter/cutter.hpp"
#include "core/tolerance.hpp"

namespace tdbd::rock {
namespace {

/// Relative to the cutter's diameter. Far above rounding, far below a mesh's edge length.
constexpr double same_place = 1e-9;

double turns_left(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 u = b - a, v = c - a;
  return u.x() * v.y() - u.y() * v.x();
}

/// Appends to a chain that only turns left. Corners closer than `slack` to its lines are omitted.
void add_to_chain(ConvexPolygon& chain, std::size_t begin, const Vec2& x, double slack) {
  while (chain.size() >= begin + 2) {
    const Vec2 &a = chain[chain.size() - 2], &b = chain.back();
    if (turns_left(a, b, x) > slack * (x - a).norm()) break;
    chain.pop_back();
  }
  chain.push_back(x);
}

}  // namespace

/// Counter-clockwise from the leftmost corner: the lower chain, then the upper one.
ConvexPolygon convex_hull(std::vector<Vec2> points, double slack) {
  std::ranges::sort(points, [](const Vec2& a, const Vec2& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  ConvexPolygon hull;
  hull.reserve(2 * points.size());
  for (const Vec2& x : points) add_to_chain(hull, 0, x, slack);
  const std::size_t lower = hull.size() - 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add_to_chain(hull, lower, points[i], slack);
  hull.pop_back();
  return hull;
}

PolygonMoments moments(const ConvexPolygon& polygon) {
  PolygonMoments m;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i - 1] - polygon[0], b = polygon[i] - polygon[0];
    const double area = 0.5 * (a.x() * b.y() - a.y() * b.x());
    m.area += area;
    m.moment += area * (polygon[0] + (a + b) / 3.0);
  }
  return m;
}

void clip(const ConvexPolygon& polygon, const HalfPlane& h, ConvexPolygon& inside) {
  inside.clear();
  inside.reserve(polygon.size() + 1);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &p = polygon[i], &q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const double out_p = h.n.dot(p) - h.b, out_q = h.n.dot(q) - h.b;
    if (out_p <= 0.0) inside.push_back(p);
    if ((out_p < 0.0 && out_q > 0.0) || (out_p > 0.0 && out_q < 0.0))
      inside.push_back(p + out_p / (out_p - out_q) * (q - p));
  }
}

FaceOutline face_outline(const bit::Cutter& c, int index, const std::vector<bit::Part>& parts) {
  const double slack = same_place * c.diameter;
  FaceOutline face{c.X_BC * Pose{Mat3::Identity(), Vec3(bit::tip_C(c).x(), 0.0, 0.0)}, {}};
  std::vector<Vec2> points;
  for (const bit::Part& part : parts) {
    if (part.cutter != index) continue;
    const Pose X_FP = inverse(face.X_BF) * part.X_BP;
    for (const Vec3& x_P : part.mesh_P.positions) {
      const Vec3 x_F = X_FP * x_P;
      if (std::abs(x_F.x()) <= tolerance::face_plane * c.diameter)
        points.emplace_back(x_F.y(), x_F.z());
    }
  }
  if (points.size() >= 3) face.rim_F = convex_hull(std::move(points), slack);
  return face;
}

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

namespace {

constexpr double ratio = 1.5;  ///< of the smallest speeds in a strip

double least_speed(const FaceColumn& c, const ForwardSpeed& v) {
  const double width = c.y1 - c.y0;
  return std::min({v({c.y0, c.lower}), v({c.y0, c.upper}),
                   v({c.y1, c.lower + c.lower_slope * width}),
                   v({c.y1, c.upper + c.upper_slope * width})});
}

}  // namespace

ForwardSpeed forward_speed(const Pose& X_BF, const rotation::Twist& twist) {
  const Vec3 n_B = X_BF.R.col(0), turning_F = X_BF.R.transpose() * n_B.cross(twist.angular_B);
  return {n_B.dot(rotation::velocity_B(twist, X_BF.p)), turning_F.tail<2>()};
}

double time_of_turn(const rotation::Twist& twist, double turn) {
  const double turning = twist.angular_B.norm();
  return turning > 0.0 ? turn / turning : std::numeric_limits<double>::infinity();
}

void face_strips(const FaceColumns& face, const ForwardSpeed& v, const SpeedRange& range,
                 double lead, double longest_time, std::vector<FaceStrip>& strips) {
  strips.clear();
  if (lead == 0.0) return strips.push_back({0, face.columns.size(), 0.0});
  const double slowest = std::max(range.slowest, lead / longest_time);
  if (std::max(range.fastest, slowest) <= ratio * slowest)
    return strips.push_back({0, face.columns.size(), lead / slowest});
  double least = 0.0, greatest = 0.0;
  for (std::size_t i = 0; i < face.columns.size(); ++i) {
    const double speed = std::max(least_speed(face.columns[i], v), lead / longest_time);
    const bool begins =
        strips.empty() || std::max(greatest, speed) > ratio * std::min(least, speed);
    least = begins ? speed : std::min(least, speed);
    greatest = begins ? speed : std::max(greatest, speed);
    const std::size_t first = begins ? i : strips.back().first;
    if (begins) strips.emplace_back();
    strips.back() = {first, i + 1, lead / least};
  }
}

namespace {

/// Relative to the cutter's diameter. Far above rounding, far below a mesh's edge length.
constexpr double same_plane = 1e-9;

}  // namespace

FlatBehind flat_behind(const bit::Cutter& c, int index, const FaceOutline& outline,
                       const std::vector<bit::Part>& parts) {
  FlatBehind flat;
  if (!(c.wear > 0.0)) return flat;
  const Mat3 R_FB = outline.X_BF.R.transpose();
  const Vec3 n_B = bit::profile_normal_B(c), n_F = R_FB * n_B;
  const double level = n_B.dot(bit::tip_B(c) - outline.X_BF.p) - c.wear;
  flat.motion_F = R_FB * bit::direction_of_motion_B(c);
  flat.edge_F = Vec2(level, -n_F.y()) / n_F.z();
  const double slack = same_plane * c.diameter;
  std::vector<Vec2> points;
  for (const bit::Part& part : parts) {
    if (part.cutter != index) continue;
    const Pose X_FP = inverse(outline.X_BF) * part.X_BP;
    for (const Vec3& x_P : part.mesh_P.positions) {
      const Vec3 x_F = X_FP * x_P;
      const double behind = -x_F.x() / flat.motion_F.x();
      if (std::abs(n_F.dot(x_F) - level) <= slack && behind >= -slack)
        points.emplace_back(x_F.y() + behind * flat.motion_F.y(), std::max(0.0, behind));
    }
  }
  if (points.size() < 3) return flat;
  flat.width = Vec3(0.0, 1.0, flat.edge_F.y()).cross(flat.motion_F).norm();
  make_columns(convex_hull(std::move(points), slack), nullptr, flat.columns);
  return flat;
}

FlatPiece flat_between(const FlatBehind& flat, double y0, double y1) {
  FlatPiece piece;
  for (const FaceColumn& c : flat.columns.columns) {
    const double from = std::max(y0, c.y0), to = std::min(y1, c.y1);
    if (!(from < to)) continue;
    const auto lower = [&](double y) { return c.lower + c.lower_slope * (y - c.y0); };
    const auto upper = [&](double y) { return c.upper + c.upper_slope * (y - c.y0); };
    const PolygonMoments above = below_line(0.0, {from, upper(from)}, {to, upper(to)}),
                         below = below_line(0.0, {from, lower(from)}, {to, lower(to)});
    const double area = above.area - below.area;
    const Vec2 moment = above.moment - below.moment;  // in y, and in the distance behind the edge
    piece.area += flat.width * area;
    piece.moment_F +=
        flat.width * (area * Vec3(0.0, 0.0, flat.edge_F.x()) +
                      moment.x() * Vec3(0.0, 1.0, flat.edge_F.y()) - moment.y() * flat.motion_F);
  }
  return piece;
}

}  // namespace tdbd::rock
