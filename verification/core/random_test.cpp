#include "core/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tdbd::random_test {

// The published test values of SplitMix64 for seed 1234567 (Rosetta Code; Vigna's splitmix64.c).
TEST(Random, gives_the_published_sequence) {
  Random random{1234567};
  EXPECT_EQ(random.next(), 6457827717110365317u);
  EXPECT_EQ(random.next(), 3203168211198807973u);
  EXPECT_EQ(random.next(), 9817491932198370423u);
  EXPECT_EQ(random.next(), 4593380528125082431u);
  EXPECT_EQ(random.next(), 16408922859458223821u);
}

TEST(Random, uniform_fills_its_interval_evenly) {
  Random random{1};
  double sum = 0.0, squares = 0.0;
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double x = random.uniform(-1, 3);
    ASSERT_GE(x, -1);
    ASSERT_LE(x, 3);
    sum += x;
    squares += x * x;
  }
  const double mean = sum / n;
  EXPECT_NEAR(mean, 1.0, 5 * std::sqrt(16.0 / 12 / n));  // wide: five standard errors
  // wide: five standard errors; the fourth moment of a width of 4 is 256 / 80
  EXPECT_NEAR(squares / n - mean * mean, 16.0 / 12, 5 * std::sqrt((256.0 / 80 - 256.0 / 144) / n));
}

}  // namespace tdbd::random_test
