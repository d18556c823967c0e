#include "rock/index/vertex_grid.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

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

}  // namespace tdbd::rock::vertex_grid_test
