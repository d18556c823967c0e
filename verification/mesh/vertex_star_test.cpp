#include "mesh/vertex_star.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/edit.hpp"
#include "mesh/surface.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/mesh/random_edit.hpp"

namespace tdbd::mesh::vertex_star_test {
namespace {

/// The neighbours of v by the corner table, counter-clockwise from any of them; open rings from their beginning.
std::vector<int> ring_by_corners(const Surface& s, int v) {
  std::vector<int> after, before;
  const int start = s.corner_of[at(v)];
  int c = start, last = start;
  do {
    after.push_back(s.vertex(next_corner(c)));
    last = c;
    c = turn_left(s, c);
  } while (c >= 0 && c != start);
  if (c == start) return after;
  after.push_back(s.vertex(previous_corner(last)));
  for (c = turn_right(s, start); c >= 0; c = turn_right(s, c))
    before.push_back(s.vertex(next_corner(c)));
  std::ranges::reverse(before);
  before.insert(before.end(), after.begin(), after.end());
  return before;
}

std::vector<int> ring_of(const Surface& s, int v) {
  const VertexStar& star = s.star(v);
  return {s.ring(star), s.ring(star) + star.size};
}

void require_stars_of_corners(const Surface& s) {
  for (int v = 0; v < s.vertex_slots(); ++v) {
    const std::vector<int> ring = ring_of(s, v);
    RC_ASSERT(ring.empty() == !s.is_alive(v));
    if (ring.empty()) continue;
    std::vector<int> expected = ring_by_corners(s, v);
    RC_ASSERT((s.star(v).open != 0) == s.is_boundary(v));
    if (!s.is_boundary(v))
      std::rotate(expected.begin(), std::ranges::min_element(expected), expected.end());
    RC_ASSERT(ring == expected);
  }
}

}  // namespace

RC_GTEST_PROP(VertexStar, equals_the_corner_table_after_any_sequence_of_edits, ()) {
  Surface s = make_surface(battery::bumpy_rock(1.0, *rc::gen::inRange(2, 6), 0.3, 1));
  require_stars_of_corners(s);
  for (const int choice : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1 << 20))) {
    random_edit(s, choice);
    RC_ASSERT(stars_are_right(s));
  }
  require_stars_of_corners(s);
}

/// A fan of 70 000 triangles: more neighbours than a star holds, and than two bytes count.
TEST(VertexStar, holds_rings_of_any_length) {
  constexpr int n = 70'000;
  constexpr double pi = std::numbers::pi;
  TriangleMesh m;
  m.positions.push_back(Vec3::Zero());
  for (int i = 0; i < n; ++i)
    m.positions.push_back(Vec3(std::cos(2.0 * pi * i / n), std::sin(2.0 * pi * i / n), 0.0));
  for (int i = 0; i < n; ++i) m.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  Surface s = make_surface(m);
  std::vector<int> all(n);
  for (int i = 0; i < n; ++i) all[at(i)] = 1 + i;
  EXPECT_EQ(ring_of(s, 0), all);
  const int middle = split_edge(s, corner_facing(s, 0, 1), Vec3(0.5, 0.0, 0.0));
  EXPECT_EQ(ring_of(s, 0).size(), all.size());
  EXPECT_EQ(ring_of(s, middle).size(), 4U);
  EXPECT_TRUE(stars_are_right(s));
  EXPECT_EQ(s.long_rings.size(), 1U + s.free_long_rings.size());
}

TEST(VertexStar, notices_a_star_out_of_step) {
  Surface s = make_surface(battery::bumpy_rock(1.0, 4, 0.3, 1));
  EXPECT_TRUE(stars_are_right(s));
  std::swap(s.stars[12].ring[0], s.stars[12].ring[1]);
  EXPECT_FALSE(stars_are_right(s));
}

}  // namespace tdbd::mesh::vertex_star_test
