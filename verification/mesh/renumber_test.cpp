#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/random.hpp"
#include "mesh/edit.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/mesh/random_edit.hpp"

namespace tdbd::mesh::renumber_test {

/// A sheet after random edits, with dead entries between the living.
Surface edited_surface() {
  Surface s = make_surface(battery::bumpy_rock(1.0, *rc::gen::inRange(2, 7), 0.3, 1));
  for (const int choice : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1 << 20)))
    random_edit(s, choice);
  return s;
}

std::vector<int> living_vertices(const Surface& s) {
  std::vector<int> vertices;
  for (int v = 0; v < s.vertex_slots(); ++v)
    if (s.is_alive(v)) vertices.push_back(v);
  return vertices;
}

/// The living vertices in any order.
std::vector<int> any_order(const Surface& s) {
  std::vector<int> order = living_vertices(s);
  Random random{static_cast<std::uint64_t>(*rc::gen::inRange(0, 1 << 20))};
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.next() % i]);
  return order;
}

/// The slow, obvious way: copies positions and triangles, sorts them and builds the adjacency.
Surface made_anew(const Surface& s, const std::vector<int>& order) {
  TriangleMesh m;
  std::vector<int> number(s.stars.size(), -1);
  for (const int v : order) {
    number[at(v)] = static_cast<int>(m.positions.size());
    m.positions.push_back(s.position(v));
  }
  for (const Triangle& t : s.triangles) {
    if (t[0] < 0) continue;
    Triangle n{number[at(t[0])], number[at(t[1])], number[at(t[2])]};
    std::rotate(n.begin(), std::ranges::min_element(n), n.end());
    m.triangles.push_back(n);
  }
  std::ranges::sort(m.triangles);
  return make_surface(m);
}

std::vector<int> ring_at(const Surface& s, int v) {
  const VertexStar& star = s.star(v);
  return {s.ring(star), s.ring(star) + star.size};
}

void require_same(const Surface& a, const Surface& b) {
  RC_ASSERT(positions_of(a) == positions_of(b));
  RC_ASSERT(a.triangles == b.triangles);
  RC_ASSERT(a.opposite == b.opposite);
  RC_ASSERT(a.corner_of == b.corner_of);
  RC_ASSERT(a.boundary == b.boundary);
  for (int v = 0; v < a.vertex_slots(); ++v) {
    RC_ASSERT(ring_at(a, v) == ring_at(b, v));
    RC_ASSERT(a.star(v).open == b.star(v).open);
  }
}

RC_GTEST_PROP(Renumbering, makes_what_make_surface_builds_of_the_triangles, ()) {
  Surface s = edited_surface();
  RenumberScratch room;
  for (int k = 0; k < 3; ++k) {  // the room is used again
    const std::vector<int> order = any_order(s);
    const Surface expected = made_anew(s, order);
    renumber(s, order, room);
    require_same(s, expected);
    RC_ASSERT(s.free_vertices.empty() && s.free_triangles.empty());
    RC_ASSERT(adjacency_is_consistent(s));
    random_edit(s, *rc::gen::inRange(0, 1 << 20));
  }
}

RC_GTEST_PROP(Renumbering, drops_the_previous_numbers, ()) {
  Surface s = edited_surface(), shuffled = s;
  RenumberScratch room;
  const std::vector<int> order = any_order(s);
  renumber(shuffled, any_order(shuffled), room);
  std::vector<int> same_order;
  for (const int v : order) same_order.push_back(room.number[at(v)]);
  renumber(shuffled, same_order, room);
  renumber(s, order, room);
  require_same(s, shuffled);
}

RC_GTEST_PROP(Renumbering, returns_the_new_numbers, ()) {
  Surface s = edited_surface();
  const Surface before = s;
  RenumberScratch room;
  renumber(s, any_order(s), room);
  RC_ASSERT(room.number.size() == before.stars.size());
  for (int v = 0; v < before.vertex_slots(); ++v) {
    const int n = room.number[at(v)];
    RC_ASSERT((n >= 0) == before.is_alive(v));
    if (n >= 0) RC_ASSERT(s.position(n) == before.position(v));
  }
}

RC_GTEST_PROP(Renumbering, leaves_a_surface_that_can_be_edited, ()) {
  Surface s = edited_surface();
  RenumberScratch room;
  renumber(s, any_order(s), room);
  for (const int choice : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1 << 20))) {
    random_edit(s, choice);
    RC_ASSERT(stars_are_consistent(s));
  }
  RC_ASSERT(adjacency_is_consistent(s));
}

/// More neighbours than a star holds.
TEST(Renumbering, takes_long_rings_along) {
  constexpr int n = 20;
  TriangleMesh m;
  m.positions.push_back(Vec3::Zero());
  for (int i = 0; i < n; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / n;
    m.positions.push_back(Vec3(std::cos(turn), std::sin(turn), 0.0));
  }
  for (int i = 0; i < n; ++i) m.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  Surface s = make_surface(m);
  std::vector<int> backwards;
  for (int v = n; v >= 0; --v) backwards.push_back(v);
  const Surface expected = made_anew(s, backwards);
  RenumberScratch room;
  renumber(s, backwards, room);
  EXPECT_EQ(ring_at(s, n), ring_at(expected, n));
  EXPECT_EQ(s.triangles, expected.triangles);
  EXPECT_TRUE(stars_are_consistent(s));
}

}  // namespace tdbd::mesh::renumber_test
