#include "rock/section/face_strips.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "verification/battery/generators.hpp"

namespace tdbd::rock::face_strips_test {

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

/// One after the other, all columns, each carried as long as its slowest point asks.
RC_GTEST_PROP(FaceStrips, hold_every_column_once_and_carry_it_far_enough, ()) {
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

/// Speeds that are known to differ by no more than a half make one strip, carried as the slowest asks. The speeds of its
/// columns, 1.2 m/s here, are asked for above that alone.
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
TEST(FaceColumns, know_the_cut_at_any_size) {
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

}  // namespace tdbd::rock::face_strips_test
