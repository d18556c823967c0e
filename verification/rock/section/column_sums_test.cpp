#include "rock/section/column_sums.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <numbers>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "reference/rock/section_by_columns.hpp"
#include "rock/section/face_columns.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock::column_sums_test {
namespace {

ConvexPolygon any_rim() {
  const double radius = *battery::number(0.1, 0.4), height = *battery::number(-0.3, 0.3);
  const int points = *battery::integer(3, 40);
  ConvexPolygon rim_F;
  for (int k = 0; k < points; ++k) {
    const double a = 2.0 * std::numbers::pi * (k + 0.3) / points;
    rim_F.emplace_back(radius * std::sin(a), height - radius * std::cos(a));
  }
  return rim_F;
}

FaceColumns columns_of(const ConvexPolygon& rim_F) {
  FaceColumns face;
  make_columns(rim_F, nullptr, face);
  return face;
}

FaceColumns any_face() { return columns_of(any_rim()); }

/// Upright ends, which are edges of no column, under a sloped top and over a sloped bottom, anywhere.
ConvexPolygon any_box() {
  const double left = *battery::number(-0.8, 0.4), right = left + *battery::number(0.2, 0.8);
  const auto low = battery::number(-0.4, -0.1), high = battery::number(0.1, 0.4);
  return {{left, *low}, {right, *low}, {right, *high}, {left, *high}};
}

/// How much of the edge from p to q lies below the line through a and b.
double length_below(const Vec2& p, const Vec2& q, const Vec2& a, const Vec2& b) {
  const auto height = [&](const Vec2& x) {
    return a.y() + (b.y() - a.y()) / (b.x() - a.x()) * (x.x() - a.x()) - x.y();
  };
  const double from = height(p), to = height(q), length = (q - p).norm();
  if (from <= 0.0 && to <= 0.0) return 0.0;
  if (from >= 0.0 && to >= 0.0) return length;
  return length * std::max(from, to) / std::abs(from - to);
}

Vec2 any_point_in(const FaceColumns& face) {
  const double y = *battery::number(face.lo_F.x(), face.hi_F.x());
  const FaceColumn& c = face.columns[face.holding(y)];
  const double share = *battery::number(0.01, 0.99), dy = y - c.y0;
  return {y, std::lerp(c.lower + c.lower_slope * dy, c.upper + c.upper_slope * dy, share)};
}

/// A chain of points in the face, to and fro.
struct Chain {
  std::vector<double> y, z;
};

Chain any_chain(const FaceColumns& face) {
  Chain chain;
  for (int k = *battery::integer(2, 14); k > 0; --k) {
    const Vec2 x_F = any_point_in(face);
    chain.y.push_back(x_F.x());
    chain.z.push_back(x_F.y());
  }
  return chain;
}

/// The sums of the chain, cut into pieces after these points.
ColumnSums inside(const FaceColumns& face, const Chain& chain,
                  const std::vector<std::size_t>& cuts) {
  ColumnSums sums;
  begin_sums(face, sums);
  std::size_t first = 0;
  for (std::size_t cut : cuts) {
    add_inside(face, std::span(chain.y).subspan(first, cut + 1 - first),
               std::span(chain.z).subspan(first, cut + 1 - first), sums);
    first = cut;
  }
  return sums;
}

}  // namespace

/// The general sum cuts each segment at every column. The tolerance is for roundings, each some
/// units of 2^-50 of the box, of as many terms.
RC_GTEST_PROP(ColumnSums, of_segments_inside_are_those_of_the_general_sum, ()) {
  const FaceColumns face = any_face();
  const Chain chain = any_chain(face);
  const ColumnSums fast = inside(face, chain, {chain.y.size() - 1});
  ColumnSums general;
  begin_sums(face, general);
  for (std::size_t k = 0; k + 1 < chain.y.size(); ++k)
    add_segment(face, 0, face.columns.size(),
                {{chain.y[k], chain.z[k]}, {chain.y[k + 1], chain.z[k + 1]}}, general);
  constexpr std::int64_t rounding = 3000;  // units
  RC_ASSERT(std::abs(fast.area - general.area) <= rounding);
  RC_ASSERT(std::abs(fast.moment_y - general.moment_y) <= rounding);
  RC_ASSERT(std::abs(fast.moment_z - general.moment_z) <= rounding);
  for (std::size_t i = 0; i < fast.engaged.size(); ++i)
    RC_ASSERT(std::abs(fast.engaged[i] - general.engaged[i]) <= rounding);
}

/// Pieces of one segment each are summed one by one, longer ones four segments at once.
RC_GTEST_PROP(ColumnSums, of_segments_inside_are_bitwise_the_same_in_any_pieces, ()) {
  const FaceColumns face = any_face();
  const Chain chain = any_chain(face);
  std::vector<std::size_t> all, some;
  for (std::size_t k = 1; k < chain.y.size(); ++k) {
    all.push_back(k);
    if (k + 1 == chain.y.size() || *battery::integer(0, 3) == 0) some.push_back(k);
  }
  const ColumnSums a = inside(face, chain, all), b = inside(face, chain, some);
  RC_ASSERT(a.area == b.area);
  RC_ASSERT(a.moment_y == b.moment_y);
  RC_ASSERT(a.moment_z == b.moment_z);
  RC_ASSERT(a.engaged == b.engaged);
  RC_ASSERT(a.engaged_moment == b.engaged_moment);
}

/// Every edge of the rim cut by the line, one by one; to the left and to the right.
RC_GTEST_PROP(ColumnSums, of_a_segment_across_the_face_have_the_rim_below_it, ()) {
  const ConvexPolygon rim_F = *battery::integer(0, 1) == 0 ? any_rim() : any_box();
  const FaceColumns face = columns_of(rim_F);
  const auto any_height = battery::number(face.lo_F.y() - 0.1, face.hi_F.y() + 0.1);
  const Vec2 left(face.lo_F.x() - 0.03, *any_height), right(face.hi_F.x() + 0.05, *any_height);
  double below = 0.0;
  for (std::size_t i = 0; i < rim_F.size(); ++i)
    below += length_below(rim_F[i], rim_F[(i + 1) % rim_F.size()], left, right);
  for (const double sign : {1.0, -1.0}) {
    ColumnSums sums;
    begin_sums(face, sums);
    const OutlineSegment s = sign > 0.0 ? OutlineSegment{right, left} : OutlineSegment{left, right};
    add_segment(face, 0, face.columns.size(), s, sums);
    double engaged = 0.0;
    for (const std::int64_t units : sums.engaged)
      engaged += static_cast<double>(units) / sums.per_length;
    RC_ASSERT(std::abs(sign * engaged - below) <= 1e-12);  // of some 1 m
  }
}

/// A point is searched for in a column near it and in the next. Beside columns that are narrower than a
/// part of the width it may lie farther on: there the circle must not answer for it.
RC_GTEST_PROP(FaceColumns, have_a_circle_in_which_every_point_is_found_inside, ()) {
  ConvexPolygon rim_F;
  double turned = *battery::number(0.0, 1.0);
  for (int k = *battery::integer(3, 9); k > 0; --k) {
    turned += *battery::number(0.2, 1.0);
    rim_F.emplace_back(std::sin(turned), -std::cos(turned));
    if (*battery::integer(0, 1) == 0) {  // another one across, at nearly the same y
      const double shift = *battery::number(-0.02, 0.02);
      rim_F.emplace_back(std::sin(turned + shift), std::cos(turned + shift));
    }
  }
  const FaceColumns face = columns_of(convex_hull(std::move(rim_F), 1e-9));
  RC_PRE(face.inner.radius2 > 0.0);
  const double radius = std::sqrt(face.inner.radius2);
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  Random random{seed};
  for (int k = 0; k < 300; ++k) {
    const FaceColumn& beside =
        face.columns[at(static_cast<int>(random.next() % face.columns.size()))];
    const Vec2 x_F(beside.y1 + random.uniform(-0.04, 0.04),
                   face.inner.centre_F.y() + random.uniform(-1.0, 1.0) * radius);
    if (!contains(face.inner, x_F)) continue;
    const FaceColumn& first = face.columns[face.near(x_F.x())];
    const FaceColumn& c = x_F.x() > first.y1 ? *(&first + 1) : first;
    const double dy = x_F.x() - c.y0;
    RC_ASSERT(x_F.x() <= c.y1);
    RC_ASSERT(x_F.y() > c.lower + c.lower_slope * dy);
    RC_ASSERT(x_F.y() < c.upper + c.upper_slope * dy);
  }
}

/// Corners of one upright edge that differ by a rounding, wherever the face is and however wide.
RC_GTEST_PROP(FaceColumns, are_none_between_corners_at_one_place, ()) {
  const double left = *battery::number(-2.0, 2.0), right = left + *battery::number(0.1, 3.0),
               low = *battery::number(-2.0, 2.0), high = low + *battery::number(0.1, 3.0);
  constexpr double same = 1e-12;  // of the width
  const double rounding = 0.9 * same * *battery::number(0.0, 1.0) * (right - left);
  const FaceColumns face =
      columns_of({{left, low}, {right - rounding, low}, {right, high}, {left + rounding, high}});
  RC_ASSERT(face.columns.size() == 1U);
  RC_ASSERT(std::abs(face.columns[0].y1 - face.columns[0].y0 - (right - left)) <=
            same * (right - left));
  const FaceColumns apart = columns_of({{left, low},
                                        {right, low},
                                        {right, high},
                                        {left + 1.1 * same * (right - left) + 1e-15, high}});
  RC_ASSERT(apart.columns.size() == 2U);
}

/// They are copied before they have an outline. Written as volatile, so that what was there before stays.
TEST(FaceColumns, have_known_values_at_the_start) {
  alignas(FaceColumns) unsigned char bytes[sizeof(FaceColumns)];
  for (volatile unsigned char& byte : bytes) byte = 0xA5;
  FaceColumns* made = new (bytes) FaceColumns;
  EXPECT_FALSE(made->left_is_rim);
  EXPECT_FALSE(made->right_is_rim);
  EXPECT_EQ(made->lo_F, Vec2::Zero());
  EXPECT_EQ(made->hi_F, Vec2::Zero());
  EXPECT_EQ(made->first_of.front(), 0);
  std::destroy_at(made);
}

}  // namespace tdbd::rock::column_sums_test

namespace tdbd::rock::section_by_columns_test {

/// Forwards along x at the origin; z of F is up.
Pose across_the_path(double y) {
  Pose X;
  X.R.col(0) = Vec3::UnitX();
  X.R.col(1) = -Vec3::UnitY();
  X.R.col(2) = -Vec3::UnitZ();
  X.p.y() = y;
  return X;
}

/// Rock up to 0.1 above a box's lower side. The corners of its triangles are multiples of an eighth
/// apart, in y and along the path: with 4 columns that are an eighth wide every column lies on
/// edges, and the face on corners, wherever the box is moved by whole eighths.
RC_GTEST_PROP(SectionByColumns, counts_a_column_on_an_edge_once, ()) {
  const mesh::TriangleMesh rock_W = battery::flat_rock(1.0, 0.0, 16);
  const double shift = 0.125 * *battery::integer(-3, 3);
  const double y = *rc::gen::element(0.0, 0.0625, 0.03);  // on edges, between them, anywhere
  const std::vector<Eigen::Vector2d> box_F{
      {-0.3125, -0.1}, {0.1875, -0.1}, {0.1875, 0.5}, {-0.3125, 0.5}};
  const reference::ColumnSection s =
      reference::section_by_columns(rock_W, across_the_path(shift + y), box_F, 4);
  RC_ASSERT(std::abs(s.area - 0.05) <= 1e-15);
  RC_ASSERT(std::abs(s.moment.x() + 0.0625 * 0.05) <= 1e-15);
  RC_ASSERT(std::abs(s.moment.y() + 0.05 * 0.05) <= 1e-15);
}

/// A circle of radius `size` in 24 corners, cut by a slanting line: below it, and the line.
struct CutCircle {
  ConvexPolygon outline;
  HalfPlane cut;
};
CutCircle cut_circle(double size, double angle) {
  ConvexPolygon circle;
  for (int k = 0; k < 24; ++k)
    circle.push_back(size * Vec2(std::cos(0.1 + k * M_PI / 12), std::sin(0.1 + k * M_PI / 12)));
  CutCircle c{{}, {Vec2(std::sin(angle), std::cos(angle)), 0.3 * size}};
  clip(circle, c.cut, c.outline);
  return c;
}

double least_at_corners(const FaceColumn& c, const ForwardSpeed& v) {
  double least = std::numeric_limits<double>::infinity();
  for (const double y : {c.y0, c.y1}) {
    const double dy = y - c.y0;
    least = std::min(
        {least, v({y, c.lower + c.lower_slope * dy}), v({y, c.upper + c.upper_slope * dy})});
  }
  return least;
}

/// All columns in turn, each carried as long as its slowest point requires.
RC_GTEST_PROP(FaceStrips, contain_every_column_once_and_carry_it_far_enough, ()) {
  FaceColumns face;
  make_columns(cut_circle(1.0, *battery::number(-0.5, 0.5)).outline, nullptr, face);
  const ForwardSpeed v{*battery::number(1.01, 3.0), battery::direction().operator*().head<2>()};
  const double lead = *battery::number(0.1, 2.0), longest = 10.0 * lead;
  double slowest = std::numeric_limits<double>::infinity(), fastest = 0.0;
  for (const FaceColumn& c : face.columns) {
    slowest = std::min(slowest, least_at_corners(c, v));
    fastest = std::max(fastest, least_at_corners(c, v));
  }
  std::vector<FaceStrip> strips;
  face_strips(face, v, {slowest, 2.0 * fastest}, lead, longest, strips);
  RC_CLASSIFY(strips.size() > 1);
  std::size_t next = 0;
  for (const FaceStrip& s : strips) {
    RC_ASSERT(s.first == next);
    RC_ASSERT(s.end > s.first);
    double least = std::numeric_limits<double>::infinity(), greatest = 0.0;
    for (std::size_t i = s.first; i < s.end; ++i) {
      const double speed = std::max(least_at_corners(face.columns[i], v), lead / longest);
      least = std::min(least, speed);
      greatest = std::max(greatest, speed);
    }
    RC_ASSERT(std::abs(s.ahead * least - lead) <= 1e-12 * lead);
    RC_ASSERT(greatest <= (1.5 + 1e-12) * least);
    next = s.end;
  }
  RC_ASSERT(next == face.columns.size());
}

int edges_of_rim(const FaceColumns& face) {
  int edges = 0;
  for (const FaceColumn& c : face.columns) edges += (c.lower_length > 0.0) + (c.upper_length > 0.0);
  return edges;
}

/// Also where a point of the face does not go forwards: 0 m at 0 m/s take no time.
TEST(FaceStrips, without_a_lead_stay_where_they_are) {
  FaceColumns face;
  make_columns(cut_circle(1.0, 0.2).outline, nullptr, face);
  std::vector<FaceStrip> strips;
  face_strips(face, {1.0, Vec2(1.0, 0.0)}, {0.0, 2.0}, 0.0, 1.0, strips);
  ASSERT_EQ(strips.size(), 1u);
  EXPECT_EQ(strips[0].first, 0u);
  EXPECT_EQ(strips[0].end, face.columns.size());
  EXPECT_EQ(strips[0].ahead, 0.0);
}

/// Speeds that are known to differ by no more than a half make one strip, carried as long as the
/// slowest requires. The speeds of its columns, 1.2 m/s here, matter only above that.
TEST(FaceStrips, of_speeds_up_to_half_as_much_again_are_one) {
  FaceColumns face;
  make_columns(cut_circle(1.0, 0.2).outline, nullptr, face);
  std::vector<FaceStrip> strips;
  for (const auto& [fastest, speed] : {std::pair{1.25, 1.0}, {1.5, 1.0}, {1.625, 1.2}}) {
    face_strips(face, {1.2, Vec2::Zero()}, {1.0, fastest}, 0.5, 100.0, strips);
    ASSERT_EQ(strips.size(), 1u);
    EXPECT_EQ(strips[0].end, face.columns.size());
    EXPECT_DOUBLE_EQ(strips[0].ahead, 0.5 / speed) << fastest;
  }
}

/// The edge along the cut is no rim, in millimetres as in kilometres.
TEST(FaceColumns, contain_the_cut_at_any_size) {
  for (const double angle : {0.0, 0.2, -0.37, 0.9}) {
    const CutCircle c = cut_circle(1.0, angle);
    FaceColumns all, made;
    make_columns(c.outline, nullptr, all);
    make_columns(c.outline, &c.cut, made);
    const int rim = edges_of_rim(made);
    EXPECT_LT(rim, edges_of_rim(all));
    for (const double size : {1e-6, 1e-3, 1e3, 1e6}) {
      const CutCircle scaled = cut_circle(size, angle);
      make_columns(scaled.outline, &scaled.cut, made);
      EXPECT_EQ(edges_of_rim(made), rim) << size << " " << angle;
    }
  }
}

}  // namespace tdbd::rock::section_by_columns_test
