#include <gtest/gtest.h>

#include "app/small_case.hpp"

namespace tdbd::app::bad_bit_test {

TEST(BadBit, a_cutter_outside_the_bit) {
  const SmallCase c;
  c.edit("bit.csv", "16,34,190", "16,84,190");
  const auto o = c.check();
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_EQ(
      o.err.rfind("tdbd: " + c.path("bit.csv").string() + ":5: r_tip_mm: found cutter 4 reaching 8",
                  0),
      0u)
      << o.err;
  EXPECT_NE(o.err.find(" mm from the axis, outside the bit, expected at most half of "
                       "gage_diameter, 50.000 mm\n"),
            std::string::npos)
      << o.err;
  EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1) << o.err;
}

TEST(BadBit, a_cutter_without_bound_when_no_gage_is_given) {
  const SmallCase c;
  c.edit("bit.toml", "gage_diameter = \"100 mm\"\n", "");
  EXPECT_EQ(c.check().exit_code, 0) << c.check().err;
}

TEST(BadBit, identical_rows) {
  const SmallCase c;
  c.edit("bit.csv", "S,4,2,nose,16,34,190,1.5,15,15,0", "S,3,1,nose,16,25,10,1,0,15,0");
  expect_refused(c, "bit.csv:5: cutter: found 3, as in line 4, expected a number of its own\n" +
                        c.path("bit.csv").string() +
                        ":5: r_tip_mm, phi_deg, h_tip_mm: found the tip of line 4, expected a tip "
                        "of its own");
}

TEST(BadBit, a_number_that_is_none) {
  const SmallCase c;
  c.edit("bit.csv", "16,34,190", "16,nan,190");
  expect_refused(c, "bit.csv:5: r_tip_mm: found 'nan', expected a number");
}

TEST(BadBit, a_missing_table) {
  const SmallCase c;
  std::filesystem::remove(c.path("bit.csv"));
  expect_refused(c, "bit.toml:2: table: found \"bit.csv\" (there is no " +
                        c.path("bit.csv").string() +
                        "), expected the path of an existing file, from the case file's folder");
}

/// A key of the pads on a bit of gage radius 47 mm (that of its outermost tip), and what is said of it.
void expect_pads_refused(const std::string& key, const std::string& message) {
  const SmallCase c;
  c.edit("bit.toml", "[mesh]", "[gage_pads]\ncount = 4\n" + key + "\n[mesh]");
  expect_refused(c, "bit.toml:6: gage_pads." + message);
}

TEST(BadBit, pads_that_are_on_no_gage) {
  expect_pads_refused("under_gage = \"200 mm\"",
                      "under_gage: found 200 mm, expected less than the gage radius, 47 mm");
  expect_pads_refused("thickness = \"47 mm\"",
                      "thickness: found 47 mm, expected more than the rise of its arc, 2.39339 mm, "
                      "and less than its outer radius, 46.6 mm");
  expect_pads_refused(
      "width = \"80 mm\"\nthickness = \"20 mm\"",
      "width: found 80 mm, expected less than 73.1991 mm, for 4 pads beside one another");
  expect_pads_refused("length = 1e30", "length: found 1e+30, expected length in m, in (0, 10]");
}

TEST(BadBit, tdbd_bit_reports_the_same) {
  const SmallCase c;
  c.edit("bit.csv", "16,34,190", "16,nan,190");
  const auto o = battery::run_tdbd({"bit", c.path("bit.toml"), "-o", c.path("out")});
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_EQ(o.err, "tdbd: " + c.path("bit.csv").string() +
                       ":5: r_tip_mm: found 'nan', expected a number\n");
  EXPECT_FALSE(std::filesystem::exists(c.path("out")));
}

}  // namespace tdbd::app::bad_bit_test
