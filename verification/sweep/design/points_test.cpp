#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <set>

#include "sweep/design/design.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::sweep::points_test {

Factor listed(const std::string& key, int count) {
  Factor f{key, {}, {}};
  for (int i = 0; i < count; ++i)
    f.levels.push_back({{std::to_string(i), std::to_string(i)}, i, ""});
  return f;
}

Design sampled(Sampling sampling, long samples, int dimensions) {
  Design d;
  d.sampling = sampling;
  d.samples = samples;
  for (int i = 0; i < dimensions; ++i)
    d.factors.push_back({"x" + std::to_string(i), {}, Interval{0.0, 1.0, "", Scale::linear}});
  return d;
}

/// The odometer: the last factor runs fastest, every combination comes once.
RC_GTEST_PROP(Points, are_all_combinations_in_the_order_of_an_odometer, ()) {
  const int a = *battery::integer(1, 4), b = *battery::integer(1, 4), c = *battery::integer(1, 4);
  Design d;
  d.fixed = {"fixed=1"};
  d.factors = {listed("a", a), listed("b", b), listed("c", c)};
  const Points points = points_of(d);
  RC_ASSERT(points.count == a * b * c);
  long index = 0;
  for (int i = 0; i < a; ++i)
    for (int j = 0; j < b; ++j)
      for (int k = 0; k < c; ++k) {
        const std::vector<std::string> expected{"fixed=1", "a=" + std::to_string(i),
                                                "b=" + std::to_string(j), "c=" + std::to_string(k)};
        RC_ASSERT(overrides_at(d, points, index++) == expected);
      }
}

/// Each column has one value in each of n equal parts (McKay, Beckman and Conover 1979).
RC_GTEST_PROP(Points, of_a_latin_hypercube_have_one_in_each_part, ()) {
  const long n = *battery::integer(1, 60);
  Design d = sampled(Sampling::latin_hypercube, n, 3);
  d.seed = static_cast<std::uint64_t>(*battery::integer(0, 1000));
  const auto rows = samples_of(d);
  for (std::size_t column = 0; column < 3; ++column) {
    std::set<long> parts;
    for (const auto& row : rows)
      parts.insert(static_cast<long>(row[column] * static_cast<double>(n)));
    RC_ASSERT(parts.size() == static_cast<std::size_t>(n));
    RC_ASSERT(*parts.begin() == 0);
    RC_ASSERT(*parts.rbegin() == n - 1);
  }
}

/// Columns are independent: no two are the same permutation, and another seed gives another design.
TEST(Points, of_a_latin_hypercube_follow_the_seed) {
  Design d = sampled(Sampling::latin_hypercube, 64, 2);
  const auto first = samples_of(d);
  EXPECT_EQ(first, samples_of(d));
  double product = 0.0;
  for (const auto& row : first) product += 12.0 * (row[0] - 0.5) * (row[1] - 0.5) / 64.0;
  EXPECT_LT(std::abs(product), 3.0 / 8.0);  // wide: three deviations of 64 independent pairs
  d.seed = 1;
  EXPECT_NE(first, samples_of(d));
}

/// A sweep that is resumed after an update finds its points: the numbers are those of the first
/// release.
TEST(Points, of_a_latin_hypercube_stay_what_they_were) {
  const std::vector<std::vector<double>> first{
      {0.0647487, 0.311234}, {0.478333, 0.790494}, {0.747983, 0.517074}};
  const auto rows = samples_of(sampled(Sampling::latin_hypercube, 3, 2));
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(rows[i][k], first[i][k], 1e-6) << i << ' ' << k;
}

/// 2^k - 1 points and the corner: each of 2^k equal parts of every column has one.
TEST(Points, of_sobol_fill_every_column_evenly) {
  const auto rows = samples_of(sampled(Sampling::sobol, 63, 5));
  EXPECT_EQ(rows.front(), std::vector<double>(5, 0.5));
  for (std::size_t column = 0; column < 5; ++column) {
    std::set<long> parts{0};  // the corner, with which the sequence begins, is left out
    for (const auto& row : rows) parts.insert(std::lround(std::floor(64.0 * row[column])));
    EXPECT_EQ(parts.size(), 64u) << column;
  }
}

TEST(Points, take_every_sample_at_every_combination) {
  Design d = sampled(Sampling::sobol, 4, 1);
  d.factors.push_back(listed("a", 3));
  const Points points = points_of(d);
  ASSERT_EQ(points.count, 12);
  EXPECT_EQ(overrides_at(d, points, 5), (std::vector<std::string>{"x0=0.75", "a=1"}));
}

}  // namespace tdbd::sweep::points_test
