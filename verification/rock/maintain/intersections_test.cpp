#include "rock/maintain/intersections.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "reference/mesh/self_intersections.hpp"
#include "verification/rock/bumpy_sheet.hpp"

namespace tdbd::rock::intersections_test {

using Pairs = std::vector<std::pair<int, int>>;

double longest_edge(const mesh::Surface& s) {
  double longest = 0.0;
  for (const auto& [a, b, c] : s.triangles)
    for (const auto& [v, w] : {std::pair{a, b}, {b, c}, {c, a}})
      longest = std::max(longest, (s.position(v) - s.position(w)).norm());
  return longest;
}

/// Triangles by their corners.
std::pair<mesh::Triangle, mesh::Triangle> by_corners(mesh::Triangle s, mesh::Triangle t) {
  std::sort(s.begin(), s.end());
  std::sort(t.begin(), t.end());
  return std::minmax(s, t);
}

using ByCorners = std::set<std::pair<mesh::Triangle, mesh::Triangle>>;

ByCorners reference_pairs(const mesh::Surface& s) {
  ByCorners pairs;
  for (const auto& [t, u] : reference::self_intersections({mesh::positions_of(s), s.triangles}))
    pairs.insert(by_corners(s.triangles[t], s.triangles[u]));
  return pairs;
}

ByCorners pairs_of(const Rock& rock, const Patch& patch) {
  IntersectionWork work;
  find_intersections(rock, patch, longest_edge(rock.surface), 1'000'000, work);
  ByCorners pairs;
  for (const auto& [t, u] : work.met) pairs.insert(by_corners(t, u));
  return pairs;
}

/// Triangle by triangle: what CGAL finds in the whole mesh.
RC_GTEST_PROP(Intersections, are_those_of_cgal, ()) {
  const Rock rock = rock_of(any_sheet(*battery::number(0.3, 1.2)));
  const mesh::Surface& s = rock.surface;
  ByCorners found;
  Patch patch;
  for (int t = 0; t < s.triangle_slots(); ++t) {
    take_triangle(s, t, patch);
    found.merge(pairs_of(rock, patch));
  }
  RC_TAG(found.empty() ? "none" : "some");
  RC_ASSERT(found == reference_pairs(s));
}

/// The pairs in which a triangle of the stars is.
RC_GTEST_PROP(Intersections, of_stars_are_those_of_their_triangles, ()) {
  const Rock rock = rock_of(any_sheet(1.0));
  const mesh::Surface& s = rock.surface;
  const std::vector<int> vertices{*battery::integer(0, s.vertex_slots() - 1),
                                  *battery::integer(0, s.vertex_slots() - 1)};
  const auto has_one = [&](const mesh::Triangle& t) {
    return std::ranges::any_of(t, [&](int v) { return std::ranges::count(vertices, v) > 0; });
  };
  ByCorners expected = reference_pairs(s);
  std::erase_if(expected,
                [&](const auto& pair) { return !has_one(pair.first) && !has_one(pair.second); });
  Patch patch;
  take_stars(s, vertices, patch);
  RC_ASSERT(pairs_of(rock, patch) == expected);
}

}  // namespace tdbd::rock::intersections_test
