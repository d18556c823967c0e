#include "sweep/table/front.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "reference/sweep/not_dominated.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::sweep::front_test {

/// Few values, so that rows are often equal in one goal or in all.
RC_GTEST_PROP(Front, agrees_with_the_slow_twin, ()) {
  const int goals = *battery::integer(1, 3), count = *battery::integer(0, 40);
  std::vector<Goal> senses;
  std::vector<char> larger;
  for (int k = 0; k < goals; ++k) {
    larger.push_back(static_cast<char>(*battery::integer(0, 1)));
    senses.push_back(
        {"g" + std::to_string(k), larger.back() != 0 ? Sense::larger : Sense::smaller});
  }
  std::vector<std::vector<double>> rows;
  for (int i = 0; i < count; ++i) {
    auto& row = rows.emplace_back();
    for (int k = 0; k < goals; ++k) row.push_back(*battery::integer(0, 5));
    if (*battery::integer(0, 9) == 0) row[0] = std::numeric_limits<double>::quiet_NaN();
  }
  RC_ASSERT(front_of(rows, senses) == reference::not_dominated(rows, larger));
}

TEST(Front, keeps_equal_rows_and_needs_a_goal) {
  EXPECT_EQ(front_of({{1.0, 2.0}, {1.0, 2.0}, {2.0, 2.0}}, {{"a"}, {"b"}}),
            (std::vector<char>{1, 1, 0}));
  EXPECT_EQ(front_of({{}, {}}, {}), (std::vector<char>{0, 0}));
}

}  // namespace tdbd::sweep::front_test
