#include "rock/index/box_columns.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "verification/battery/generators.hpp"

namespace tdbd::rock::box_columns_test {

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

}  // namespace tdbd::rock::box_columns_test
