#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "sweep/table/journal.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::sweep::filter_test {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr auto left_out = KeptAs::left_out, best = KeptAs::best, sample = KeptAs::sample;

/// The best ones, the first of equal ones, never a NaN; larger is better if the design specifies
/// it.
TEST(Judged, keeps_the_best) {
  const std::vector<double> figure{3.0, none, 1.0, 2.0, 1.0};
  const auto kept = [&](Sense sense, long keep) {
    return judged_by({{"x", sense}, keep, 0}, figure).kept;
  };
  EXPECT_EQ(kept(Sense::smaller, 1),
            (std::vector<KeptAs>{left_out, left_out, best, left_out, left_out}));
  EXPECT_EQ(kept(Sense::smaller, 3), (std::vector<KeptAs>{left_out, left_out, best, best, best}));
  EXPECT_EQ(kept(Sense::larger, 2),
            (std::vector<KeptAs>{best, left_out, left_out, best, left_out}));
  EXPECT_EQ(kept(Sense::smaller, 9), (std::vector<KeptAs>{best, left_out, best, best, best}));
  EXPECT_TRUE(Judged{}.keeps(7));
}

/// The others are the middles of equal shares of the ranking; a third of keep by default.
TEST(Judged, samples_the_rest_of_the_ranking) {
  std::vector<double> figure;
  for (int i = 0; i < 12; ++i) figure.push_back(i);
  const auto sampled = [&](const Filter& filter) {
    std::vector<int> found;
    const Judged judged = judged_by(filter, figure);
    for (int i = 0; i < 12; ++i)
      if (judged.kept[static_cast<std::size_t>(i)] == sample) found.push_back(i);
    return found;
  };
  EXPECT_EQ(sampled({{"x"}, 2, 2}), (std::vector<int>{4, 9}));
  EXPECT_EQ(sampled({{"x"}, 4}), (std::vector<int>{6, 10}));
  EXPECT_EQ(sampled({{"x"}, 10, 7}), (std::vector<int>{10, 11}));
  EXPECT_EQ(sampled({{"x"}, 12, 7}), (std::vector<int>{}));
}

/// Ranks with means for equal values, counted one by one.
std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<double> found;
  for (const double x : values) {
    double below = 0.0, equal = 0.0;
    for (const double y : values) {
      below += y < x ? 1.0 : 0.0;
      equal += y == x ? 1.0 : 0.0;
    }
    found.push_back(below + 0.5 * (equal + 1.0));
  }
  return found;
}

double pearson(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double mean_a = 0.0, mean_b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    mean_a += a[i] / n;
    mean_b += b[i] / n;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
    ab += (a[i] - mean_a) * (b[i] - mean_b);
  }
  return ab / std::sqrt(aa * bb);
}

/// Few values, so that many are equal.
RC_GTEST_PROP(RankCorrelation, is_that_of_ranks_counted_one_by_one, ()) {
  std::vector<double> a{0.0, 1.0, 2.0}, b{1.0, 0.0, 3.0};
  for (int i = *battery::integer(0, 20); i > 0; --i) {
    a.push_back(*battery::integer(0, 5));
    b.push_back(*battery::integer(0, 5));
  }
  RC_ASSERT(std::abs(rank_correlation(a, b) - pearson(ranks(a), ranks(b))) < 1e-14);
}

TEST(RankCorrelation, is_one_of_any_growing_relation_and_unknown_of_too_few) {
  EXPECT_NEAR(rank_correlation(std::vector{1.0, 2.0, 5.0}, std::vector{1.0, 8.0, 125.0}), 1.0,
              1e-15);
  EXPECT_NEAR(rank_correlation(std::vector{1.0, 2.0, none, 5.0}, std::vector{3.0, 2.0, 9.0, 1.0}),
              -1.0, 1e-15);
  EXPECT_TRUE(std::isnan(rank_correlation(std::vector{1.0, 2.0}, std::vector{1.0, 2.0})));
  EXPECT_TRUE(std::isnan(rank_correlation(std::vector{1.0, 1.0, 1.0}, std::vector{1.0, 2.0, 3.0})));
}

PointRecord record_with(double cost, double gain) {
  return {{PointStatus::done, "h", "", {cost, gain}, false}, 0.5};
}

/// Four points: two best, one sample, one left out; the unchanged case counts for the correlation.
TEST(FilterReport, compares_what_was_run_with_the_figure_of_the_same_name) {
  Design d;
  d.figures = {"gain", "cost"};
  d.filter = Filter{{"cost", Sense::smaller}, 2, 1};
  Judged judged = judged_by(*d.filter, {1.0, 2.0, 3.0, 4.0});
  judged.unchanged = 5.0;
  ASSERT_EQ(judged.kept, (std::vector<KeptAs>{best, best, left_out, sample}));
  const PointRecord a = record_with(1.0, 20.0), b = record_with(2.0, 10.0),
                    c = record_with(3.0, 30.0), unchanged = record_with(4.0, 40.0);
  const std::vector<const PointRecord*> points{&a, &b, nullptr, &c};
  const FilterReport r = filter_report(d, judged, points, &unchanged);
  EXPECT_EQ(r.filter, "planar.cost");
  EXPECT_EQ(r.figure, "cost");
  EXPECT_EQ(r.points, 4);
  EXPECT_EQ(r.best, 2);
  EXPECT_NEAR(r.of_all, 0.8, 1e-15);  // 1 - 6 * 2/(4 * 15)
  EXPECT_TRUE(std::isnan(r.of_best));
  EXPECT_EQ(r.unchanged_figure, 40.0);
  EXPECT_EQ(r.best_point, 1);
  EXPECT_EQ(filter_csv(d, judged, points, &unchanged),
            "run as,point,planar.cost,gain,cost\n"
            "unchanged,,5,4,40\nbest,0,1,1,20\nbest,1,2,2,10\nsample,3,4,3,30\n");
}

/// Otherwise with the first goal, and then with the first figure.
TEST(FilterReport, compares_with_a_goal_if_no_figure_has_the_name) {
  Design d;
  d.figures = {"gain", "cost"};
  d.filter = Filter{{"imbalance", Sense::smaller}, 2, 1};
  EXPECT_EQ(compared_figure(d), 0u);
  d.goals = {{"cost", Sense::smaller}};
  EXPECT_EQ(compared_figure(d), 1u);
}

}  // namespace tdbd::sweep::filter_test
