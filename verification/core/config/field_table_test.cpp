#include <gtest/gtest.h>

#include "core/config/csv.hpp"
#include "core/error.hpp"
#include "verification/core/temporary_file.hpp"

namespace tdbd::field_table_test {

constexpr const char* las = R"(~VERSION INFORMATION
 VERS.    2.0 : CWLS LOG ASCII STANDARD
 WRAP.     NO : one line for each row
~WELL INFORMATION
 STRT.S   0.0 : start
 NULL. -999.25 : no value
# a comment
~CURVE INFORMATION
 TIME.S       : time
 RPM .RPM     : rotary speed
 ROP .M/HR  12 34 : rate of the block
 HKLA.KLBF    : hook load
~A  TIME  RPM  ROP  HKLA
 0.0  60  36  100
 1.0  90  72  -999.25
)";

constexpr const char* csv =
    "time [s],RPM (rpm),ROP [m/h],hook load [klbf],flow\n0,60,36,100,NaN\n1,90,72,,x\n";

FieldTable table(const char* text, const char* suffix) {
  return read_field_table(write_temporary(suffix, text));
}

std::string reason(const auto& act) {
  try {
    act();
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

std::string error_message_of(const char* text, const char* suffix, const char* column,
                             const char* unit) {
  return reason([&] { field_column(table(text, suffix), column, unit); });
}

/// 60 rpm are 2 pi rad/s, 36 m/h are 1 cm/s, 100 klbf are 444822.16 N.
TEST(FieldTable, reads_columns_of_both_formats) {
  constexpr double pi = 3.14159265358979, rounding = 1e-14;
  for (const auto& [text, suffix] : {std::pair{las, ".LAS"}, {csv, ".csv"}}) {
    const FieldTable t = table(text, suffix);
    const std::vector<double> speed = field_column(t, "RPM", "rad/s");
    ASSERT_EQ(speed.size(), 2U);
    EXPECT_NEAR(speed[0], 2.0 * pi, rounding);
    EXPECT_NEAR(speed[1], 3.0 * pi, rounding);
    EXPECT_NEAR(field_column(t, "ROP", "m/s")[1], 0.02, rounding);
    EXPECT_NEAR(field_column(t, "ROP [KN]", "N")[0], 36e3, 1e3 * rounding);
    EXPECT_NEAR(field_column(t, "ROP [m/min]", "m/s")[0], 0.6, rounding) << "the given unit";
  }
}

TEST(FieldTable, names_the_row_that_has_no_value) {
  constexpr const char* expected =
      ", expected a number in each row: fill the gap or cut the record";
  EXPECT_TRUE(error_message_of(las, ".las", "HKLA", "N")
                  .ends_with(".las:15: HKLA: found no value, \"-999.25\"" + std::string(expected)));
  EXPECT_TRUE(error_message_of(csv, ".csv", "hook load", "N")
                  .ends_with(".csv:3: hook load: found no value, \"\"" + std::string(expected)));
  EXPECT_TRUE(error_message_of(csv, ".csv", "flow [m]", "m")
                  .ends_with(".csv:2: flow: found no value, \"NaN\"" + std::string(expected)));
}

TEST(FieldTable, lists_the_columns_of_the_file_where_one_is_missing) {
  EXPECT_TRUE(error_message_of(las, ".las", "HKLD", "N")
                  .ends_with(".las:1: HKLD: found no column of this name, expected one of TIME, "
                             "RPM, ROP, HKLA"));
}

TEST(FieldTable, rejects_units_that_are_missing_or_of_another_dimension) {
  EXPECT_TRUE(error_message_of(csv, ".csv", "flow", "m3/s")
                  .ends_with(".csv:1: flow: found no unit, expected one in the header or in the "
                             "case, as in \"flow [m3/s]\""));
  EXPECT_TRUE(error_message_of(las, ".las", "ROP", "rad/s")
                  .ends_with(".las:1: ROP: found the unit \"M/HR\", expected a unit of angular "
                             "speed in rad/s"));
}

TEST(FieldTable, rejects_what_is_no_table) {
  const auto refused = [](const char* text, const char* suffix) {
    return reason([&] { table(text, suffix); });
  };
  EXPECT_TRUE(refused("~V\nWRAP. YES : \n", ".las")
                  .ends_with(".las:2: WRAP: found YES, expected NO: one line for each row"));
  EXPECT_TRUE(refused("~V\nWRAP. NO :\n~A\n", ".las")
                  .ends_with(".las:1: ~Curve: found no columns, expected a section of LAS 2.0 that "
                             "names them"));
  EXPECT_TRUE(refused("~C\nA.M :\n~A\n1 2\n", ".las")
                  .ends_with(".las:4: row: found 2 values, expected 1, one for each column"));
  EXPECT_TRUE(refused("a,b\n1\n", ".csv")
                  .ends_with(".csv:2: row: found 1 values, expected 2, one for each column"));
  EXPECT_TRUE(refused("a,b\n", ".csv")
                  .ends_with(".csv:1: rows: found none, expected a row of values for each time"));
}

}  // namespace tdbd::field_table_test
