#include "rock/index/vertex_grid.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "rock/index/box_columns.hpp"
#include "rock/index/near_list.hpp"
#include "rotation/screw.hpp"
#include "verification/battery/generators.hpp"
#include "verification/rock/index/grid_query.hpp"

namespace tdbd::rock::vertex_grid_test {

using mesh::Box;

const Box unit_box{Vec3(-1, -1, -1), Vec3(1, 1, 1)};

/// The grid and what it should hold. Points reach far out of the grid's box.
struct Indexed {
  VertexGrid grid;
  std::map<int, Vec3> points;
};

Box box_around(const Vec3& a, const Vec3& b) {
  Box box;
  box.add(a);
  box.add(b);
  return box;
}

/// The vertices that the grid offers for a box; each at most once.
std::set<int> visited(const VertexGrid& grid, const Region& box) {
  std::set<int> found;
  visit_vertices(grid, box, [&](int v) { RC_ASSERT(found.insert(v).second); });
  return found;
}

void check_query(const Indexed& x, const Box& box) {
  const std::set<int> found = visited(x.grid, {box});
  for (const int v : found) RC_ASSERT(x.points.contains(v));
  for (const auto& [v, p] : x.points)
    if (box.contains(p)) RC_ASSERT(found.contains(v));
}

/// Inserts an unknown vertex; moves or removes a known one.
void change(Indexed& x, int v, const Vec3& p, bool remove) {
  const bool known = x.points.contains(v);
  if (known && remove) {
    x.grid.remove(v);
    x.points.erase(v);
    return;
  }
  if (known)
    x.grid.move(v, p);
  else
    x.grid.insert(v, p);
  x.points[v] = p;
}

RC_GTEST_PROP(VertexGrid, offers_all_vertices_in_a_box_after_any_changes, ()) {
  Indexed x{VertexGrid(unit_box, *battery::number(0.05, 3.0)), {}};
  const auto changes = *rc::gen::container<std::vector<std::tuple<int, Vec3, bool>>>(
      rc::gen::tuple(rc::gen::inRange(0, 30), battery::point(2.0), rc::gen::arbitrary<bool>()));
  for (const auto& [v, p, remove] : changes) {
    change(x, v, p, remove);
    check_query(x, box_around(p, p));
  }
  for (int k = 0; k < 5; ++k)
    check_query(x, box_around(*battery::point(3.0), *battery::point(3.0)));
  RC_ASSERT(visited(x.grid, {Box{Vec3::Constant(-9), Vec3::Constant(9)}}).size() ==
            x.points.size());
}

bool contains(const Region& r, const Vec3& x) {
  return r.box.contains(x) && std::ranges::all_of(r.slabs, [&](const Slab& s) {
           return s.lo <= s.n.dot(x) && s.n.dot(x) <= s.hi;
         });
}

/// Slabs in any direction, also along the axes, may cut the box; the grid may be far smaller.
Region any_region() {
  Region r{box_around(*battery::point(3.0), *battery::point(3.0))};
  for (Slab& s : r.slabs) {
    s.n = *rc::gen::oneOf(
        rc::gen::map(battery::point(1.0),
                     [](const Vec3& n) -> Vec3 {
                       return n.norm() > 1e-3 ? n.normalized() : Vec3(Vec3::UnitX());
                     }),
        rc::gen::map(battery::integer(0, 2), [](int i) -> Vec3 { return Vec3::Unit(i); }));
    const double a = *battery::number(-2.0, 2.0), b = *battery::number(-2.0, 2.0);
    s.lo = std::min(a, b);
    s.hi = std::max(a, b);
  }
  return r;
}

RC_GTEST_PROP(VertexGrid, offers_all_vertices_between_slabs, ()) {
  Indexed x{VertexGrid(unit_box, *battery::number(0.05, 1.0)), {}};
  std::vector<Vec3> positions;
  for (int v = 0; v < 200; ++v) positions.push_back(*battery::point(2.0));
  std::vector<int> all(positions.size());
  std::iota(all.begin(), all.end(), 0);
  x.grid.insert_all(positions, all);
  const Region r = any_region();
  const std::set<int> found = visited(x.grid, r);
  for (const int v : all)
    if (contains(r, positions[static_cast<std::size_t>(v)])) RC_ASSERT(found.contains(v));
}

double radius(const Vec3& x) { return x.head<2>().norm(); }

double true_nearest(const Indexed& x, double z_lo, double z_hi) {
  double nearest = INFINITY;
  for (const auto& [v, p] : x.points)
    if (z_lo <= p.z() && p.z() <= z_hi) nearest = std::min(nearest, radius(p));
  return nearest;
}

/// Whatever moved, left or came: never farther than the truth, and as far as that, but for single
/// precision, once every layer was refreshed.
RC_GTEST_PROP(VertexGrid, bounds_the_distance_to_the_axis, ()) {
  Indexed x{VertexGrid(unit_box, *battery::number(0.05, 3.0)), {}};
  const auto changes = *rc::gen::container<std::vector<std::tuple<int, Vec3, bool>>>(
      rc::gen::tuple(rc::gen::inRange(0, 30), battery::point(2.0), rc::gen::arbitrary<bool>()));
  for (const auto& [v, p, remove] : changes) change(x, v, p, remove);
  const double a = *battery::number(-2.0, 2.0), b = *battery::number(-2.0, 2.0);
  const double lo = std::min(a, b), hi = std::max(a, b);
  RC_ASSERT(x.grid.nearest_to_axis(lo, hi) <= true_nearest(x, lo, hi));
  for (int k = 0; k < 50; ++k) x.grid.refresh_one_layer();
  RC_ASSERT(x.grid.nearest_to_axis(lo, hi) <= true_nearest(x, lo, hi));
  const double all = true_nearest(x, -9, 9);
  constexpr double single = 2e-6;  // of the radius
  RC_ASSERT(all == INFINITY || x.grid.nearest_to_axis(-9, 9) >= (1.0 - single) * all);
}

/// Slabs are closed, as boxes are: a vertex on one's face is inside.
TEST(VertexGrid, offers_what_lies_on_the_face_of_a_slab) {
  const Box box{Vec3(-8, -8, -8), Vec3(8, 8, 8)};
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      VertexGrid grid(box, 1.0);
      Vec3 x(0.5, 0.5, 0.5);
      x[axis] = side;  // a corner of a cell
      grid.insert(0, x);
      Region region{box_around(Vec3(-2, -2, -2), Vec3(2, 2, 2)), {}};
      for (int k = 0; k < 3; ++k)
        region.slabs[static_cast<std::size_t>(k)] = {Vec3::Unit(k), -1.0, 1.0};
      EXPECT_EQ(visited(grid, region), std::set<int>{0}) << axis << " " << side;
    }
}

/// A query reads cells, not the whole grid: a small box far from all vertices offers none.
TEST(VertexGrid, offers_nothing_from_far_cells) {
  VertexGrid grid(unit_box, 0.1);
  for (int v = 0; v < 100; ++v) grid.insert(v, Vec3(-0.9, -0.9, -0.9 + 0.001 * v));
  int offered = 0;
  visit_vertices(grid, {Box{Vec3(0.5, 0.5, 0.5), Vec3(0.6, 0.6, 0.6)}}, [&](int) { ++offered; });
  EXPECT_EQ(offered, 0);
}

TEST(VertexGrid, holds_vertices_on_its_own_faces_and_beyond) {
  VertexGrid grid(unit_box, 0.3);
  grid.insert(0, Vec3(1, 1, 1));
  grid.insert(1, Vec3(-1, -1, -1));
  grid.insert(2, Vec3(1e6, -1e6, 0));
  const auto offers = [&](int v, const Vec3& x) {
    bool found = false;
    visit_vertices(grid, {Box{x, x}}, [&](int w) { found = found || w == v; });
    return found;
  };
  EXPECT_TRUE(offers(0, {1, 1, 1}));
  EXPECT_TRUE(offers(1, {-1, -1, -1}));
  EXPECT_TRUE(offers(2, {1e6, -1e6, 0}));
}

/// Of coordinates that often are equal, so that boxes touch; sometimes one without points.
mesh::Box any_box() {
  mesh::Box b;
  if (*rc::gen::element(0, 0, 0, 1) == 1) return b;
  const auto any = [] {
    return Vec3(*rc::gen::element(-1.0, 0.0, 1.0 / 3.0, 0.1),
                *rc::gen::element(-1e-3, 0.0, 1.0 / 3.0, 7.0), *battery::number(-1.0, 1.0));
  };
  b.add(any());
  b.add(any());
  return b;
}

/// Coordinates that differ in their last digits.
mesh::Box nudged(mesh::Box b) {
  b.lo.x() = std::nextafter(b.lo.x(), *rc::gen::element(-1e9, 1e9));
  b.hi.y() = std::nextafter(b.hi.y(), *rc::gen::element(-1e9, 1e9));
  return b;
}

std::vector<std::size_t> overlapping(const BoxColumns& columns, const mesh::Box& b) {
  std::vector<std::size_t> found;
  visit_overlapping(columns, b, [&](std::size_t i) { found.push_back(i); });
  return found;
}

/// In order, and each but once.
RC_GTEST_PROP(BoxColumns, have_every_box_that_overlaps, ()) {
  std::vector<mesh::Box> boxes;
  const int count = *battery::integer(0, 140);
  for (int i = 0; i < count; ++i) boxes.push_back(nudged(any_box()));
  BoxColumns columns;
  resize(columns, boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) set_box(columns, i, boxes[i]);
  const mesh::Box b = nudged(any_box());
  const std::vector<std::size_t> found = overlapping(columns, b);
  RC_ASSERT(std::ranges::is_sorted(found));
  RC_ASSERT(std::ranges::adjacent_find(found) == found.end());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (boxes[i].overlaps(b)) RC_ASSERT(std::ranges::binary_search(found, i));
  if (!found.empty()) RC_ASSERT(found.back() < boxes.size());
}

TEST(BoxColumns, leave_out_boxes_that_are_apart) {
  BoxColumns columns;
  resize(columns, 9);
  for (std::size_t i = 0; i < 9; ++i) {
    const double x = static_cast<double>(i);
    set_box(columns, i, {Vec3(x, 0.0, 0.0), Vec3(x + 0.9, 1.0, 1.0)});
  }
  EXPECT_EQ(overlapping(columns, {Vec3(0.95, 0, 0), Vec3(2.5, 1, 1)}),
            (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(overlapping(columns, {Vec3(8.5, 0, 0), Vec3(9.5, 1, 1)}),
            (std::vector<std::size_t>{8}));
  EXPECT_TRUE(overlapping(columns, {Vec3(0.5, 1.1, 0), Vec3(2.5, 2, 1)}).empty());
  EXPECT_TRUE(overlapping(columns, mesh::Box{}).empty());
  resize(columns, 9);
  EXPECT_TRUE(overlapping(columns, {Vec3(0, 0, 0), Vec3(9, 1, 1)}).empty());
}

}  // namespace tdbd::rock::vertex_grid_test

namespace tdbd::rock::list_places_test {

/// A list of random places, near an origin or flat along an axis.
NearList any_list(std::size_t places) {
  NearList list;
  make_room(list, places);
  const double flat = *rc::gen::element(0.0, 1e-3, 1.0);
  for (std::size_t i = 0; i < places; ++i) {
    const Vec3 x = *battery::point(0.3);
    list.x[i] = static_cast<Single>(x.x());
    list.y[i] = static_cast<Single>(flat * x.y());
    list.z[i] = static_cast<Single>(x.z() + 0.1);
    list.v[i] = static_cast<int>(i);
  }
  close(list, places);
  return list;
}

Vec3 place(const NearList& list, std::size_t i) { return {list.x[i], list.y[i], list.z[i]}; }

/// A ball about the middle of the box of each pack, through its farthest place.
RC_GTEST_PROP(Balls, contain_the_positions_of_their_packs_and_no_more, ()) {
  constexpr double rounding = 2.3e-8;  // m, of single precision at half a metre
  const auto places = 8 * static_cast<std::size_t>(*battery::integer(1, 5));
  const NearList list = any_list(places);
  for (std::size_t pack = 0; pack < places / 8; ++pack) {
    mesh::Box box;
    for (std::size_t i = 8 * pack; i < 8 * pack + 8; ++i) box.add(place(list, i));
    const Vec3 middle(list.balls.x[pack], list.balls.y[pack], list.balls.z[pack]);
    RC_ASSERT((middle - 0.5 * (box.lo + box.hi)).norm() < rounding);
    double farthest = 0.0;
    for (std::size_t i = 8 * pack; i < 8 * pack + 8; ++i)
      farthest = std::max(farthest, (place(list, i) - middle).norm());
    RC_ASSERT(farthest <= list.balls.radius[pack]);
    RC_ASSERT(list.balls.radius[pack] < 1.0011 * farthest + rounding);
  }
}

const mesh::Box box_P{Vec3(-8e-3, -6e-3, -2e-3), Vec3(8e-3, 6e-3, 2e-3)};

/// The box at both poses, between planes normal to its axes at the second, as rock/cut makes it.
Region region_of(const Pose& X_WP0, const Pose& X_WP1) {
  Region r;
  for (std::size_t k = 0; k < 3; ++k) {
    Slab& s = r.slabs[k];
    s = {X_WP1.R.col(static_cast<int>(k)), INFINITY, -INFINITY};
    for (const Pose* X_WP : {&X_WP0, &X_WP1})
      for (int i = 0; i < 8; ++i) {
        const double along = s.n.dot(*X_WP * Vec3(i & 1 ? box_P.hi.x() : box_P.lo.x(),
                                                  i & 2 ? box_P.hi.y() : box_P.lo.y(),
                                                  i & 4 ? box_P.hi.z() : box_P.lo.z()));
        s.lo = std::min(s.lo, along);
        s.hi = std::max(s.hi, along);
      }
  }
  r.box = box_around(r.slabs);
  return r;
}

/// A cutter anywhere on a bit of 8.5 in at up to 120 rpm and 1 ms, without margins: its region for
/// eight steps contains them all, so that volumes alone do not force new lists in each step.
RC_GTEST_PROP(NearRegion, holds_all_the_steps_it_is_made_for, ()) {
  constexpr int steps = 8;
  const Pose X_BP{(*battery::pose(1.0)).R, Vec3(*battery::number(0.0, 0.108), 0.0, 0.0)};
  const Mat3 turn = rotation::exp(Vec3(0.0, 0.0, *battery::number(0.0, 0.0126)));
  Pose X_WB{Mat3::Identity(), Vec3::Zero()};
  const auto next_of = [&](const Pose& X) {
    return Pose{Mat3(turn * X.R), X.p + Vec3(0.0, 0.0, 4e-6)};
  };
  Region ahead;
  for (int k = 0; k < steps; ++k) {
    const Pose next = next_of(X_WB), X_WP0 = X_WB * X_BP, X_WP1 = next * X_BP;
    const Region r = region_of(X_WP0, X_WP1);
    if (k == 0) ahead = region_ahead({box_P, X_WP0, X_WP1, r}, {}, steps);
    RC_ASSERT(holds(ahead, r));
    X_WB = next;
  }
}

TEST(NearRegion, reports_what_it_contains) {
  const Pose X{Mat3::Identity(), Vec3::Zero()};
  const Region r = region_of(X, X);
  EXPECT_TRUE(holds(widened(r, 1e-6), r));
  EXPECT_FALSE(holds(r, widened(r, 1e-6)));
}

}  // namespace tdbd::rock::list_places_test
