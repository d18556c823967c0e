#include "core/nearest_name.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace tdbd::nearest_name_test {

TEST(NearestName, distance_counts_the_textbook_examples) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("abc", ""), 3u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("flaw", "lawn"), 2u);
}

TEST(NearestName, finds_a_misspelt_name_and_nothing_for_a_strange_one) {
  const std::vector<std::string> names{"radius", "azimuth", "rpm"};
  EXPECT_EQ(nearest_name("raduis", names), "radius");
  EXPECT_EQ(nearest_name("rpn", names), "rpm");
  EXPECT_EQ(nearest_name("temperature", names), std::nullopt);
  EXPECT_EQ(nearest_name("radius", {}), std::nullopt);
}

TEST(NearestName, takes_the_first_of_equally_near_names) {
  EXPECT_EQ(nearest_name("rod", {"rad", "red"}), "rad");
}

RC_GTEST_PROP(NearestName, distance_is_a_metric,
              (const std::string& a, const std::string& b, const std::string& c)) {
  RC_ASSERT(edit_distance(a, a) == 0u);
  RC_ASSERT((edit_distance(a, b) == 0u) == (a == b));
  RC_ASSERT(edit_distance(a, b) == edit_distance(b, a));
  RC_ASSERT(edit_distance(a, c) <= edit_distance(a, b) + edit_distance(b, c));
  RC_ASSERT(edit_distance(a, b) <= std::max(a.size(), b.size()));
}

}  // namespace tdbd::nearest_name_test
