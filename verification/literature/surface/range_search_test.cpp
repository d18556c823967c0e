#include "reference/literature/surface/range_search.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "rock/index/vertex_grid.hpp"
#include "verification/battery/generators.hpp"
#include "verification/rock/index/grid_query.hpp"

namespace tdbd::reference::range_search_test {
namespace {

std::vector<Vec3> any_points(int most) {
  std::vector<Vec3> points;
  const int count = *battery::integer(0, most);
  for (int i = 0; i < count; ++i) points.push_back(*battery::point(1.0));
  return points;
}

/// Between two places, of which either may be a point of the set: its sides then hold points.
SearchBox any_box(const std::vector<Vec3>& points) {
  const auto corner = [&] {
    if (points.empty() || *rc::gen::arbitrary<bool>()) return *battery::point(1.2);
    return points[at(*battery::integer(0, static_cast<int>(points.size()) - 1))];
  };
  const Vec3 a = corner(), b = corner();
  return {a.cwiseMin(b), a.cwiseMax(b)};
}

std::vector<int> found_in_order(const RangeSearch& search, const SearchBox& box) {
  std::vector<int> found;
  search.find(box, found);
  std::ranges::sort(found);
  return found;
}

/// What our index finds in the box: it offers what may be inside.
std::vector<int> found_by_our_index(const std::vector<Vec3>& points, const SearchBox& box) {
  std::vector<int> all(points.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  rock::VertexGrid grid({Vec3::Constant(-0.8), Vec3::Constant(0.8)}, 0.3);
  grid.insert_all(points, all);
  const mesh::Box ours{box.lo, box.hi};
  std::vector<int> found;
  rock::visit_vertices(grid, {ours, {}}, [&](int v) {
    if (ours.contains(points[at(v)])) found.push_back(v);
  });
  std::ranges::sort(found);
  return found;
}

std::vector<int> found_one_by_one(const std::vector<Vec3>& points, const SearchBox& box) {
  std::vector<int> found;
  for (std::size_t i = 0; i < points.size(); ++i)
    if ((points[i].array() >= box.lo.array()).all() && (points[i].array() <= box.hi.array()).all())
      found.push_back(static_cast<int>(i));
  return found;
}

RC_GTEST_PROP(RangeSearch, finds_what_our_index_finds, ()) {
  const std::vector<Vec3> points = any_points(300);
  const RangeSearch search(points);
  for (int i = 0; i < 10; ++i) {
    const SearchBox box = any_box(points);
    const std::vector<int> found = found_in_order(search, box);
    RC_ASSERT(found == found_by_our_index(points, box));
    RC_ASSERT(found == found_one_by_one(points, box));
  }
}

RC_GTEST_PROP(RangeSearch, finds_points_where_they_have_moved, ()) {
  std::vector<Vec3> points = any_points(100);
  RangeSearch search(points);
  for (Vec3& x : points) x += *battery::point(0.5);
  search.refit(points);
  const SearchBox box = any_box(points);
  RC_ASSERT(found_in_order(search, box) == found_one_by_one(points, box));
}

TEST(RangeSearch, takes_points_in_one_place) {
  const std::vector<Vec3> points(100, Vec3(1, 2, 3));
  const RangeSearch search(points);
  std::vector<int> found;
  search.find({{1, 2, 3}, {1, 2, 3}}, found);
  EXPECT_EQ(found.size(), 100U);
  search.find({{0, 0, 0}, {1, 2, 2.9}}, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace tdbd::reference::range_search_test
