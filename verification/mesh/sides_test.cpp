#include "mesh/sides.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <tuple>

namespace tdbd::mesh::sides_test {

auto key(const Side& s) { return std::tuple(s.lo, s.hi, s.corner, s.triangle, s.forward); }

/// Any triangles, dead ones among them: few vertices, so that many sides share an edge.
std::vector<Triangle> some_triangles() {
  std::vector<Triangle> triangles;
  const int n = *rc::gen::inRange(0, 40), vertices = *rc::gen::inRange(3, 30);
  for (int i = 0; i < n; ++i) {
    const auto any = [&] { return *rc::gen::inRange(0, vertices); };
    triangles.push_back(*rc::gen::inRange(0, 5) == 0 ? Triangle{-1, any(), any()}
                                                     : Triangle{any(), any(), any()});
  }
  return triangles;
}

RC_GTEST_PROP(SortedSides, are_all_sides_of_the_living_by_edge_and_corner, ()) {
  const std::vector<Triangle> triangles = some_triangles();
  std::vector<std::tuple<int, int, int, int, bool>> expected;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    for (int i = 0; i < 3 && triangles[at(t)][0] >= 0; ++i) {
      const int from = triangles[at(t)][at((i + 1) % 3)], to = triangles[at(t)][at((i + 2) % 3)];
      expected.emplace_back(std::min(from, to), std::max(from, to), 3 * t + i, t, from < to);
    }
  std::ranges::sort(expected);
  const std::vector<Side> sides = sorted_sides(triangles);
  RC_ASSERT(sides.size() == expected.size());
  for (std::size_t i = 0; i < sides.size(); ++i) RC_ASSERT(key(sides[i]) == expected[i]);
}

}  // namespace tdbd::mesh::sides_test
