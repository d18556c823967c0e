#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "sweep/design/design.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::sweep::levels_test {

TEST(Levels, know_number_and_unit_of_a_word) {
  const Level speed = level_of({"60 rpm", "\"60 rpm\""});
  EXPECT_EQ(speed.number, 60.0);
  EXPECT_EQ(speed.unit, "rpm");
  EXPECT_EQ(level_of({"-2.5e-3", "-2.5e-3"}).number, -2.5e-3);
  EXPECT_EQ(level_of({"-2.5e-3", "-2.5e-3"}).unit, "");
  EXPECT_FALSE(level_of({"bits/bit-a.toml", "\"bits/bit-a.toml\""}).number);
  EXPECT_FALSE(level_of({"true", "true"}).number);
  EXPECT_FALSE(level_of({"nan", "nan"}).number);
}

/// What a level overrides is the number itself: no digit is lost on the way through the text.
RC_GTEST_PROP(Levels, are_read_back_bitwise_identical, ()) {
  const double x = *battery::number(-1e6, 1e6);
  RC_ASSERT(level_of(level_at(x, "mm").word).number == x);
  RC_ASSERT(level_of(level_at(x, "").word).number == x);
  RC_ASSERT(level_at(x, "mm").word.toml == "\"" + level_at(x, "mm").word.text + "\"");
}

/// Ends exact, equal steps or equal ratios.
RC_GTEST_PROP(Levels, are_evenly_spread, ()) {
  const double from = *battery::number(0.1, 2.0), to = from + *battery::number(0.1, 50.0);
  const int count = *battery::integer(2, 9);
  for (const Scale scale : {Scale::linear, Scale::log}) {
    const std::vector<Level> levels = levels_in({from, to, "m", scale}, count);
    RC_ASSERT(levels.size() == static_cast<std::size_t>(count));
    RC_ASSERT(levels.front().number == from);
    RC_ASSERT(levels.back().number == to);
    const auto at = [&](std::size_t i) {
      return scale == Scale::log ? std::log(*levels[i].number) : *levels[i].number;
    };
    const double step = (at(levels.size() - 1) - at(0)) / (count - 1);
    for (std::size_t i = 1; i < levels.size(); ++i)
      RC_ASSERT(std::abs(at(i) - at(i - 1) - step) <
                1e-12 * std::abs(at(levels.size() - 1)) + 1e-14);
  }
}

}  // namespace tdbd::sweep::levels_test
