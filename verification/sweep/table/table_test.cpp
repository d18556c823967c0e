#include "sweep/table/table.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "verification/sweep/small_design.hpp"

namespace tdbd::sweep::table_test {

Design two_by_two() {
  Design d;
  d.figures = {"cost", "gain"};
  d.factors = {{"size", {{{"1 mm", ""}, 1.0, "mm"}, {{"2 mm", ""}, 2.0, "mm"}}, {}},
               {"kind", {{{"a, b", ""}, {}, ""}, {{"7", ""}, 7.0, ""}}, {}}};
  d.goals = {{"cost", Sense::smaller}, {"gain", Sense::larger}};
  return d;
}

PointRecord record_with(double cost, double gain) {
  return {{PointStatus::done, "h", "", {cost, gain}, false}, 0.5};
}

TEST(Table, has_a_row_for_each_point) {
  const Design d = two_by_two();
  const double none = std::numeric_limits<double>::quiet_NaN();
  const PointRecords records{
      {"0", record_with(1.0, 1.0)},
      {"1", record_with(2.0, 1.0)},
      {"2", {{PointStatus::failed, "", "no, \"never\"", {none, none}, false}, 0.5}}};
  const Table t = table_of(d, points_of(d), {"0", "1", "2", "3"}, records);
  EXPECT_EQ(done_points(t), 3);
  EXPECT_EQ(to_csv(t),
            "point,size [mm],kind,cost,gain,front,status,case_hash,message\n"
            "0,1,\"a, b\",1,1,1,done,h,\n"
            "1,1,7,2,1,0,done,h,\n"
            "2,2,\"a, b\",nan,nan,0,failed,,\"no, \"\"never\"\"\"\n"
            "3,2,7,nan,nan,0,missing,,\n");
}

TEST(Table, of_a_filter_has_what_was_judged_and_what_was_left_out) {
  Design d = two_by_two();
  d.goals.clear();
  d.filter = Filter{{"imbalance", Sense::smaller}, 1};
  const PointRecords records{{"2", record_with(1.0, 1.0)}, {"3", record_with(2.0, 1.0)}};
  const Table t = table_of(d, points_of(d), {"0", "1", "2", "3"}, records,
                           judged_by(*d.filter, {0.5, 0.25, 0.125, 4.0}));
  EXPECT_EQ(points_to_run(t), 1);
  EXPECT_EQ(to_csv(t),
            "point,size [mm],kind,planar.imbalance,cost,gain,status,case_hash,message\n"
            "0,1,\"a, b\",0.5,nan,nan,left-out,,\n"
            "1,1,7,0.25,nan,nan,left-out,,\n"
            "2,2,\"a, b\",0.125,1,1,done,h,\n"
            "3,2,7,4,nan,nan,left-out,,\n");
}

/// The first point of Sobol is the middle.
TEST(Table, has_sampled_factors_as_numbers) {
  Design d;
  d.figures = {"cost"};
  d.factors = {{"size", {}, Interval{1.0, 2.0, "mm", Scale::linear}}};
  d.sampling = Sampling::sobol;
  d.samples = 1;
  EXPECT_EQ(to_csv(table_of(d, points_of(d), {"0"}, {})),
            "point,size [mm],cost,status,case_hash,message\n0,1.5,nan,missing,,\n");
}

/// The best ones, the first of equal ones, never a NaN; larger is better if the design specifies
/// it.
TEST(Judged, keeps_the_best) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> figure{3.0, none, 1.0, 2.0, 1.0};
  const auto kept = [&](Sense sense, long keep) {
    return judged_by({{"x", sense}, keep}, figure).kept;
  };
  EXPECT_EQ(kept(Sense::smaller, 1), (std::vector<char>{0, 0, 1, 0, 0}));
  EXPECT_EQ(kept(Sense::smaller, 3), (std::vector<char>{0, 0, 1, 1, 1}));
  EXPECT_EQ(kept(Sense::larger, 2), (std::vector<char>{1, 0, 0, 1, 0}));
  EXPECT_EQ(kept(Sense::smaller, 9), (std::vector<char>{1, 0, 1, 1, 1}));
  EXPECT_TRUE(Judged{}.keeps(7));
}

}  // namespace tdbd::sweep::table_test
