#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "core/text.hpp"

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

/// Names of too different a length are not measured: nothing else changes.
RC_GTEST_PROP(NearestName, is_the_first_at_the_least_distance_of_all, (const std::string& name)) {
  const auto letters = rc::gen::container<std::string>(rc::gen::inRange('a', 'd'));
  const auto names = *rc::gen::container<std::vector<std::string>>(letters);
  const std::string word = name.size() % 2 == 0 ? *letters : name;
  std::optional<std::string> nearest;
  for (const std::string& n : names)
    if (const auto d = edit_distance(word, n);
        3 * d <= std::max({word.size(), n.size(), std::size_t{3}}))
      if (!nearest || d < edit_distance(word, *nearest)) nearest = n;
  RC_ASSERT(nearest_name(word, names) == nearest);
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
