#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <chrono>
#include <string>

#include "core/text.hpp"

namespace tdbd::wildcard_test {

TEST(Wildcard, matches_any_text_or_one_character) {
  EXPECT_TRUE(fits("*", ""));
  EXPECT_TRUE(fits("cutter-*/face", "cutter-12/face"));
  EXPECT_TRUE(fits("c?t*e", "cutter-12/face"));
  EXPECT_FALSE(fits("cutter-*/face", "cutter-12/body"));
  EXPECT_FALSE(fits("cutter-?/face", "cutter-12/face"));
  EXPECT_FALSE(fits("", "a"));
}

/// The definition, which tries every length of every *.
bool fits_by_definition(std::string_view pattern, std::string_view name) {
  if (pattern.empty()) return name.empty();
  if (pattern.front() == '*')
    return fits_by_definition(pattern.substr(1), name) ||
           (!name.empty() && fits_by_definition(pattern, name.substr(1)));
  return !name.empty() && (pattern.front() == '?' || pattern.front() == name.front()) &&
         fits_by_definition(pattern.substr(1), name.substr(1));
}

std::string any_text(const std::string& letters, int longest) {
  std::string text;
  for (int left = *rc::gen::inRange(0, longest + 1); left > 0; --left)
    text += letters[*rc::gen::inRange<std::size_t>(0, letters.size())];
  return text;
}

RC_GTEST_PROP(Wildcard, agrees_with_its_definition, ()) {
  const std::string pattern = any_text("ab*?", 8), name = any_text("ab", 10);
  RC_ASSERT(fits(pattern, name) == fits_by_definition(pattern, name));
}

/// The definition takes more than 1e12 comparisons here.
TEST(Wildcard, is_decided_in_the_product_of_the_lengths) {
  std::string pattern;
  for (int i = 0; i < 20; ++i) pattern += "*a";
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(fits(pattern + "b", std::string(1000, 'a')));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
}

}  // namespace tdbd::wildcard_test
