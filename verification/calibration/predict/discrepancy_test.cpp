#include <gtest/gtest.h>

#include "calibration/made_up_laboratory.hpp"
#include "calibration/predict/prediction.hpp"

namespace tdbd::calibration::discrepancy_test {
namespace {

Discrepancy of_all(CalibrationCase c, const LaboratoryNoise& noise, double wrong_bit) {
  const CutStore cuts = made_up_cuts(c);
  c.fit = {"A", "B", "C"};
  c.predict = {};
  read_loads(c, cuts, hidden_law(), noise, 4);
  for (Record& r : c.records.rows)
    for (Reading& reading : r.readings)
      if (r.tool == "A") *reading.value *= wrong_bit;
  return leave_one_tool_out(c, cuts, records_of(c, c.fit));
}

TEST(Discrepancy, is_none_where_the_law_is_right) {
  const Discrepancy d = of_all(well_conditioned_case(), {}, 1.0);
  EXPECT_EQ(d.reason, "");
  EXPECT_EQ(d.value[axial], 0.0);
  EXPECT_EQ(d.value[turning], 0.0);
}

/// One of three bits needs a third more than the law of the others predicts.
TEST(Discrepancy, is_what_a_bit_differs_by) {
  const Discrepancy d = of_all(well_conditioned_case(), {0.01, 0.0}, 1.3);
  EXPECT_EQ(d.reason, "");
  for (const std::size_t k : {axial, turning}) {
    EXPECT_GT(d.value[k], 0.1);
    EXPECT_LT(d.value[k], 0.5);
  }
}

/// Missing loads contribute nothing; the others contribute as before.
TEST(Discrepancy, is_found_from_the_loads_that_were_read) {
  CalibrationCase c = well_conditioned_case();
  const CutStore cuts = made_up_cuts(c);
  c.fit = {"A", "B", "C"};
  c.predict = {};
  read_loads(c, cuts, hidden_law(), {0.01, 0.0}, 4);
  for (Record& r : c.records.rows)
    if (r.tool == "A") *r.readings[turning].value *= 1.3;
  const Discrepancy all = leave_one_tool_out(c, cuts, records_of(c, c.fit));
  for (Record& r : c.records.rows)
    if (r.tool == "A") r.readings[axial].value.reset();
  const Discrepancy some = leave_one_tool_out(c, cuts, records_of(c, c.fit));
  EXPECT_EQ(some.reason, "");
  EXPECT_GT(all.value[turning], 0.1);
  EXPECT_NEAR(some.value[turning] / all.value[turning], 1.0, 5.5e-3);
}

TEST(Discrepancy, of_one_bit_is_unknown) {
  CalibrationCase c = well_conditioned_case();
  const CutStore cuts = made_up_cuts(c);
  read_loads(c, cuts, hidden_law());
  c.fit = {"B"};
  EXPECT_EQ(leave_one_tool_out(c, cuts, records_of(c, c.fit)).reason, "only one bit is fitted");
}

TEST(Discrepancy, is_unknown_where_a_bit_alone_identifies_nothing) {
  CalibrationCase c = well_conditioned_case();
  const CutStore cuts = made_up_cuts(c);
  read_loads(c, cuts, hidden_law());
  for (Record& r : c.records.rows)
    if (r.tool == "C")
      for (Reading& reading : r.readings) reading.value.reset();
  EXPECT_EQ(leave_one_tool_out(c, cuts, records_of(c, c.fit)).reason,
            "without B the coefficients are not identifiable");
}

}  // namespace
}  // namespace tdbd::calibration::discrepancy_test
