#include "rock/section/crossing_segments.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "core/random.hpp"
#include "mesh/measures.hpp"
#include "rotation/screw.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock::crossing_segments_test {
namespace {

/// A vertex and its distance ahead of the plane.
struct Seen {
  int v;
  Vec3 x_W;
  double ahead;
};

/// The twin: the outline found triangle by triangle, over the corners of the surface.
class WalkByCorners {
 public:
  WalkByCorners(const mesh::Surface& s, const FacePlane& plane) : s_(s), f_(plane) {}

  std::vector<OutlineSegment> segments;

  void around(int v);
  bool is_in_zone(const Vec2& x_F) const;
  bool is_start(const Seen& a) const {
    if (!(a.ahead >= 0.0 && a.ahead <= f_.reach)) return false;
    const Vec2 x_F = f_.in_plane(a.x_W);
    return x_F.y() <= f_.top && x_F.y() >= f_.face.lo_F.y() - f_.reach && is_in_zone(x_F);
  }
  Seen seen(int v) const {
    const Vec3& x_W = s_.position(v);
    return {v, x_W, f_.ahead(x_W)};
  }

 private:
  Seen seen_at(int corner) const { return seen(s_.vertex(corner)); }
  /// An edge gives its two triangles the same point.
  Vec2 crossing(const Seen& ahead, const Seen& behind) const {
    const double w = ahead.ahead / (ahead.ahead - behind.ahead);
    return f_.in_plane(ahead.x_W + w * (behind.x_W - ahead.x_W));
  }
  void triangle(int c, const Seen& v, const Seen& next, const Seen& last, bool ask_before);
  void follow(int facing, int ahead, int behind, Vec2 from);
  void follow_back(int facing, int ahead, int behind, Vec2 to);

  const mesh::Surface& s_;
  const FacePlane& f_;
  std::vector<OutlineSegment> run_;
};

bool WalkByCorners::is_in_zone(const Vec2& x_F) const {
  const FaceColumns& face = f_.face;
  if (x_F.x() < f_.left - f_.reach || x_F.x() > f_.right + f_.reach) return false;
  if (x_F.y() > face.hi_F.y() + f_.reach) return false;
  const double y = std::clamp(x_F.x(), f_.left, f_.right);
  const FaceColumn& c = face.columns[face.near(y)];
  const double below = c.lower + c.lower_slope * (x_F.x() - c.y0) - x_F.y();
  return below <= f_.reach * c.lower_rise;
}

/// The corner of a vertex from which turning left reaches all others.
int first_corner(const mesh::Surface& s, int v) {
  const int start = s.corner_of[at(v)];
  if (!s.is_boundary(v)) return start;
  int c = start;
  for (int right = mesh::turn_right(s, c); right >= 0; right = mesh::turn_right(s, c)) c = right;
  return c;
}

/// The triangles that cross the plane on an edge from this vertex to one behind.
void WalkByCorners::around(int v) {
  const Seen centre = seen(v);
  const int first = first_corner(s_, v);
  Seen next = seen_at(mesh::next_corner(first));
  bool ask_before = true;
  int c = first;
  do {
    const Seen last = seen_at(mesh::previous_corner(c));
    if (next.ahead < 0.0) triangle(c, centre, next, last, ask_before);
    ask_before = next.ahead >= 0.0;
    next = last;
    c = mesh::turn_left(s_, c);
  } while (c >= 0 && c != first);
}

/// The triangle with this corner at v. Follows the outline on either side where the vertex ahead is
/// none to start from; the side before may be known to be around v, too.
void WalkByCorners::triangle(int c, const Seen& v, const Seen& next, const Seen& last,
                             bool ask_before) {
  const Vec2 from = crossing(v, next);
  const Vec2 to = last.ahead >= 0.0 ? crossing(last, next) : crossing(v, last);
  segments.push_back({from, to});
  if (last.ahead >= 0.0 && !is_start(last)) follow(c, last.v, next.v, to);
  const int before = ask_before ? s_.opposite_of(mesh::previous_corner(c)) : -1;
  if (before < 0) return;
  const Seen u = seen_at(before);
  if (u.ahead >= 0.0 && !is_start(u)) follow_back(mesh::previous_corner(c), v.v, next.v, from);
}

/// Follows the outline over the edge that this corner faces, until it leaves the zone or reaches a
/// vertex to start from.
void WalkByCorners::follow(int facing, int ahead, int behind, Vec2 from) {
  while (is_in_zone(from)) {
    const int o = s_.opposite_of(facing);
    if (o < 0) return;
    const Seen a = seen(ahead), b = seen(behind), w = seen_at(o);
    const bool turns = w.ahead >= 0.0;
    const Vec2 to = turns ? crossing(w, b) : crossing(a, w);
    segments.push_back({from, to});
    if (turns && is_start(w)) return;
    (turns ? ahead : behind) = w.v;
    facing = turns ? mesh::next_corner(o) : mesh::previous_corner(o);
    from = to;
  }
}

/// Follows the outline back over the edge that this corner faces. What leads back to a vertex to
/// start from is found from there; otherwise it is kept.
void WalkByCorners::follow_back(int facing, int ahead, int behind, Vec2 to) {
  run_.clear();
  while (is_in_zone(to)) {
    const int o = s_.opposite_of(facing);
    if (o < 0) break;
    const Seen a = seen(ahead), b = seen(behind), w = seen_at(o);
    const bool turns = w.ahead >= 0.0;
    if (turns && is_start(w)) return;
    const Vec2 from = turns ? crossing(w, b) : crossing(a, w);
    run_.push_back({from, to});
    (turns ? ahead : behind) = w.v;
    facing = turns ? mesh::previous_corner(o) : mesh::next_corner(o);
    to = from;
  }
  segments.insert(segments.end(), run_.begin(), run_.end());
}

std::vector<OutlineSegment> by_corners(const Rock& rock, const FacePlane& plane) {
  WalkByCorners walk(rock.surface, plane);
  for (int v = 0; v < rock.surface.vertex_slots(); ++v)
    if (rock.surface.is_alive(v) && walk.is_start(walk.seen(v))) walk.around(v);
  return walk.segments;
}

std::array<double, 4> numbers(const OutlineSegment& s) {
  return {s.from.x(), s.from.y(), s.to.x(), s.to.y()};
}

std::vector<std::array<double, 4>> sorted(const std::vector<OutlineSegment>& segments) {
  std::vector<std::array<double, 4>> all;
  for (const OutlineSegment& s : segments) all.push_back(numbers(s));
  std::ranges::sort(all);
  return all;
}

Rock rock_of(const mesh::TriangleMesh& m, double cell) {
  return make_rock(mesh::make_surface(m), cell, mesh::bounding_box(m));
}

/// Bumps, and steps across which the sheet falls: outlines with holes in sight, islands and tops.
mesh::TriangleMesh any_rock() {
  mesh::TriangleMesh m =
      battery::bumpy_rock(1.0, *battery::integer(6, 30), *battery::number(0.0, 0.45),
                          *rc::gen::arbitrary<std::uint64_t>());
  const double slope = *battery::number(0.2, 3.0), step = *battery::number(-0.4, 0.4),
               where = *battery::number(-0.5, 0.5);
  const bool has_step = *rc::gen::arbitrary<bool>();
  for (Vec3& x_W : m.positions) {
    x_W.z() *= slope;
    if (has_step && x_W.y() > where) x_W.z() += step;
  }
  return m;
}

FaceColumns any_face() {
  const double radius = *battery::number(0.1, 0.4);
  const int points = *battery::integer(3, 40);
  ConvexPolygon rim_F;
  for (int k = 0; k < points; ++k) {
    const double a = 2.0 * std::numbers::pi * (k + 0.3) / points;
    rim_F.emplace_back(radius * std::sin(a), -radius * std::cos(a));
  }
  FaceColumns face;
  make_columns(rim_F, nullptr, face);
  return face;
}

/// A face across the sheet, and some of its columns.
FacePlane any_plane(const FaceColumns& face) {
  const int count = static_cast<int>(face.columns.size()), first = *battery::integer(0, count - 1),
            end = *battery::integer(first + 1, count);
  Pose X_WF;
  X_WF.R << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  X_WF.R = rotation::exp(*battery::point(1.0)) * X_WF.R;
  X_WF.p = *battery::point(0.3);
  const double top = *battery::number(face.lo_F.y(), face.hi_F.y());
  return face_plane(X_WF, face, at(first), at(end), *battery::number(0.02, 0.3), top, -1);
}

bool is_within(const FacePlane& plane, const Vec2& x_F) {
  if (!(x_F.x() > plane.left && x_F.x() < plane.right)) return false;
  return std::ranges::any_of(plane.face.columns, [&](const FaceColumn& c) {
    const double dy = x_F.x() - c.y0;
    return dy >= 0.0 && x_F.x() <= c.y1 && x_F.y() > c.lower + c.lower_slope * dy &&
           x_F.y() < c.upper + c.upper_slope * dy;
  });
}

std::vector<OutlineSegment> segments(const OutlineWork& w) {
  std::vector<OutlineSegment> all;
  for (const OutlineRun& run : w.runs)
    for (std::size_t k = run.first; k + 1 < run.end; ++k)
      all.push_back({{w.y[k], w.z[k]}, {w.y[k + 1], w.z[k + 1]}});
  return all;
}

bool is_inside(const PlacedPoint& p) { return p.place == PointPlace::inside; }

/// Segments beneath the face leave the sums of all columns as they were.
void check_segment(const FacePlane& plane, const OutlineWork& w, std::size_t k) {
  if (!is_beneath(w, k)) return;
  const OutlineSegment s{{w.y[k], w.z[k]}, {w.y[k + 1], w.z[k + 1]}};
  ColumnSums sums;
  begin_sums(plane.face, sums);
  add_segment(plane.face, 0, plane.face.columns.size(), s, sums);
  RC_ASSERT(std::abs(sums.area) <= 2);  // of 2^50 units
  for (const std::int64_t length : sums.engaged) RC_ASSERT(std::abs(length) <= 2);
}

}  // namespace

RC_GTEST_PROP(CrossingSegments, are_those_of_the_walk_from_triangle_to_triangle, ()) {
  const Rock rock = rock_of(any_rock(), 0.2);
  const FaceColumns face = any_face();
  const FacePlane plane = any_plane(face);
  OutlineWork work;
  for (int again = 0; again < 2; ++again) {
    find_outline(rock, plane, work);
    RC_ASSERT(sorted(segments(work)) == sorted(by_corners(rock, plane)));
  }
  for (std::size_t k = 0; k < work.y.size(); ++k)
    if (is_inside(work.place[k])) RC_ASSERT(is_within(plane, {work.y[k], work.z[k]}));
  for (const OutlineRun& run : work.runs)
    for (std::size_t k = run.first; k + 1 < run.end; ++k) check_segment(plane, work, k);
  RC_CLASSIFY(!work.runs.empty(), "found");
  RC_CLASSIFY(std::ranges::any_of(work.place, is_inside), "inside");
}

/// Heights at random, of which many are too far ahead to start from: the outline passes many vertices
/// twice, and one of the passages may be found from that vertex alone.
RC_GTEST_PROP(CrossingSegments, are_those_of_the_walk_on_rugged_rock, ()) {
  mesh::TriangleMesh m = battery::flat_rock(1.0, 0.0, *battery::integer(4, 12));
  Random random{*rc::gen::arbitrary<std::uint64_t>()};
  for (Vec3& x_W : m.positions) x_W.z() = random.uniform(-0.3, 0.3);
  const double size = *battery::number(0.2, 1.2);
  FaceColumns face;
  make_columns({{-size, -size}, {size, -size}, {size, size}, {-size, size}}, nullptr, face);
  Pose X_WF;  // its normal goes up
  X_WF.R << 0, 1, 0, 0, 0, -1, -1, 0, 0;
  const FacePlane plane = face_plane(X_WF, face, 0, face.columns.size(),
                                     *battery::number(0.02, 0.3), *battery::number(0.0, size), -1);
  OutlineWork work;
  const Rock rock = rock_of(m, 0.2);
  find_outline(rock, plane, work);
  RC_ASSERT(sorted(segments(work)) == sorted(by_corners(rock, plane)));
}

/// A single vertex ahead of the plane: no neighbour determines where its outline begins.
TEST(CrossingSegments, go_all_around_a_lone_vertex_ahead) {
  mesh::TriangleMesh m = battery::flat_rock(1.0, 0.0, 10);
  const auto middle = std::ranges::find_if(
      m.positions, [](const Vec3& x_W) { return x_W.head<2>().norm() < 1e-9; });
  middle->z() = -0.05;
  FaceColumns face;
  make_columns({{-0.3, -0.3}, {0.3, -0.3}, {0.3, 0.3}, {-0.3, 0.3}}, nullptr, face);
  Pose X_WF;  // its normal goes up
  X_WF.R << 0, 1, 0, 0, 0, -1, -1, 0, 0;
  X_WF.p = Vec3(0.0, 0.0, -0.02);
  const FacePlane plane = face_plane(X_WF, face, 0, face.columns.size(), 0.2, 0.3, -1);
  OutlineWork work;
  const Rock rock = rock_of(m, 0.2);
  find_outline(rock, plane, work);
  EXPECT_GE(segments(work).size(), 4U);
  EXPECT_EQ(sorted(segments(work)), sorted(by_corners(rock, plane)));
  EXPECT_TRUE(std::ranges::all_of(work.place, is_inside));
}

/// More than 64 neighbours, up and down: the outline passes the middle many times.
TEST(CrossingSegments, pass_a_vertex_of_many_neighbours_as_often_as_it_is_crossed) {
  constexpr int count = 150;
  mesh::TriangleMesh m;
  for (int k = 0; k < count; ++k) {
    const double a = 2.0 * std::numbers::pi * k / count;
    m.positions.emplace_back(std::cos(a), std::sin(a), k % 5 < 2 ? 0.05 : -0.01);
    m.triangles.push_back({count, (k + 1) % count, k});
  }
  m.positions.emplace_back(0.0, 0.0, -0.03);
  FaceColumns face;
  make_columns({{-2.0, -2.0}, {2.0, -2.0}, {2.0, 2.0}, {-2.0, 2.0}}, nullptr, face);
  Pose X_WF;  // its normal goes up
  X_WF.R << 0, 1, 0, 0, 0, -1, -1, 0, 0;
  const FacePlane plane = face_plane(X_WF, face, 0, face.columns.size(), 0.2, 2.0, -1);
  OutlineWork work;
  const Rock rock = rock_of(m, 0.2);
  find_outline(rock, plane, work);
  EXPECT_EQ(segments(work).size(), 90U);
  EXPECT_EQ(sorted(segments(work)), sorted(by_corners(rock, plane)));
}

}  // namespace tdbd::rock::crossing_segments_test

namespace tdbd::rock::crossed_edges_test {

/// Emptied now and then, and far more than it has margin for at first.
RC_GTEST_PROP(CrossedEdges, are_a_set_that_grows_and_is_emptied, ()) {
  CrossedEdges edges;
  for (int k = 0; k < 4; ++k) {
    const int count = *rc::gen::element(0, 10, 1000, 3000), vertices = *battery::integer(1, 2000);
    const auto seed = static_cast<unsigned>(*battery::integer(0, 1 << 20));
    std::set<std::pair<int, int>> expected;
    for (unsigned j = 0; j < static_cast<unsigned>(count); ++j) {
      const unsigned mixed = (seed + j) * 2654435761U;
      const int v = static_cast<int>(mixed >> 4U) % vertices, i = static_cast<int>(mixed % 200U);
      RC_ASSERT(edges.contains(v, i) == expected.contains({v, i}));
      RC_ASSERT(edges.add(v, i) == expected.insert({v, i}).second);
    }
    for (const auto& [v, i] : expected) RC_ASSERT(edges.contains(v, i));
    for (const auto& [v, i] : expected) RC_ASSERT(!edges.is_done(v));
    for (const auto& [v, i] : expected)
      if (i < 64 && v % 2 == 0) edges.mark_done(v);
    for (int v = 0; v < vertices; ++v) {
      const auto first = expected.lower_bound({v, 0});
      const bool has_low = first != expected.end() && first->first == v && first->second < 64;
      RC_ASSERT(edges.is_done(v) == (has_low && v % 2 == 0));
    }
    edges.clear();
    for (const auto& [v, i] : expected) RC_ASSERT(!edges.is_done(v) && !edges.contains(v, i));
  }
}

}  // namespace tdbd::rock::crossed_edges_test
