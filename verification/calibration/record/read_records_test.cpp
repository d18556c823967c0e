#include <gtest/gtest.h>

#include "calibration/record/record.hpp"
#include "core/error.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::calibration::read_records_test {
namespace {

constexpr const char* good_header =
    "test,bit,pressure [psi],rotary_speed [rpm],rate_of_penetration [m/h],wob [kN],tob [N m]\n";
constexpr const char* good_row = "B-1,B,3000,120,10,42.5,3100\n";

std::string written(const std::string& text) {
  const std::string path = temporary_folder() + "records.csv";
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

/// The message with FILE for the file's path.
std::string refusal(const std::string& text) {
  const std::string path = written(text);
  try {
    read_records(path);
  } catch (const InputError& e) {
    std::string message = e.what();
    for (std::size_t at = 0; (at = message.find(path)) != std::string::npos;)
      message.replace(at, path.size(), "FILE");
    return message;
  }
  return "";
}

Records records(const std::string& text) { return read_records(written(text)); }

std::string row(const std::string& cells) { return good_header + cells + "\n"; }

TEST(ReadRecords, of_bits_are_in_si) {
  const Records r = records(std::string(good_header) + good_row);
  EXPECT_EQ(r.kind, ToolKind::bit);
  ASSERT_EQ(r.rows.size(), 1u);
  const Record& one = r.rows[0];
  EXPECT_EQ(one.test, "B-1");
  EXPECT_EQ(one.tool, "B");
  EXPECT_EQ(one.line, 2);
  EXPECT_DOUBLE_EQ(one.pressure, 3000 * 6894.757293168361);
  EXPECT_DOUBLE_EQ(one.speed, 4 * 3.14159265358979323846);
  EXPECT_DOUBLE_EQ(one.rate, 10.0 / 3600.0);
  EXPECT_DOUBLE_EQ(one.depth, 10.0 / 3600.0 / 2.0);
  EXPECT_DOUBLE_EQ(*one.readings[axial].value, 42500.0);
  EXPECT_DOUBLE_EQ(*one.readings[turning].value, 3100.0);
  EXPECT_FALSE(one.readings[axial].deviation);
}

TEST(ReadRecords, have_headers_in_any_case_and_with_either_brackets) {
  const Records r = records(
      "Test;BIT;Pressure (PSI);Rotary speed [RPM];Rate-of-penetration [m/hr];WOB (kN);TOB [Nm];\n"
      "B-1;B;3000;120;10,5;42,5;3100;\n;;;;;;;\n");
  ASSERT_EQ(r.rows.size(), 1u);
  EXPECT_DOUBLE_EQ(r.rows[0].pressure, 3000 * 6894.757293168361);
  EXPECT_DOUBLE_EQ(r.rows[0].rate, 10.5 / 3600.0);
  EXPECT_DOUBLE_EQ(*r.rows[0].readings[axial].value, 42500.0);
  EXPECT_DOUBLE_EQ(*r.rows[0].readings[turning].value, 3100.0);
}

TEST(ReadRecords, doubt_the_null_values_of_logs) {
  const Records r = records(row("1,B,3000,120,10,999.25,3100"));
  ASSERT_EQ(r.doubts.size(), 1u);
  EXPECT_TRUE(
      r.doubts[0].ends_with(":2: wob: 999.25 usually means \"no value\" in logs; leave the "
                            "cell empty, or leave out the row"))
      << r.doubts[0];
  EXPECT_TRUE(records(row("1,B,3000,120,10,42.5,3100")).doubts.empty());
}

TEST(ReadRecords, of_cutters_have_a_depth_and_no_rate) {
  const Records r = records(
      "drag [lbf],test,normal [lbf],cutter,depth [mm],speed [mm/s],normal_sd [N],rock\n"
      "100,1,200,c13,1.5,500,30,berea-sandstone\n");
  EXPECT_EQ(r.kind, ToolKind::cutter);
  const Record& one = r.rows.at(0);
  EXPECT_DOUBLE_EQ(one.depth, 1.5e-3);
  EXPECT_EQ(one.rate, 0.0);
  EXPECT_EQ(one.pressure, 0.0);
  EXPECT_EQ(one.rock, "berea-sandstone");
  EXPECT_DOUBLE_EQ(*one.readings[axial].value, 200 * 4.4482216152605);
  EXPECT_DOUBLE_EQ(*one.readings[turning].value, 100 * 4.4482216152605);
  EXPECT_DOUBLE_EQ(*one.readings[axial].deviation, 30.0);
}

/// Relative; a conversion rounds once or twice.
constexpr double rounding = 1e-15;

TEST(ReadRecords, units_do_not_matter) {
  const Record a = records(row("1,B,3000,120,10,42.5,3100")).rows.at(0);
  const Record b = records(
                       "bit,test,tob [kN m],pressure [MPa],rate_of_penetration [m/s],wob "
                       "[N],rotary_speed [deg/s]\n"
                       "B,1,3.1,20.684271879505083,0.0027777777777777778,42500,720\n")
                       .rows.at(0);
  EXPECT_NEAR(b.pressure / a.pressure, 1.0, rounding);
  EXPECT_NEAR(b.depth / a.depth, 1.0, rounding);
  for (const std::size_t k : {axial, turning})
    EXPECT_NEAR(*b.readings[k].value / *a.readings[k].value, 1.0, rounding);
}

TEST(ReadRecords, a_byte_order_mark_crlf_comments_and_empty_lines_are_tolerated) {
  const Records r = records(
      "\xef\xbb\xbf# from the log book\r\n\r\ntest,bit,pressure [psi],rotary_speed "
      "[rpm],rate_of_penetration [m/h],wob [kN]\r\n1,B,3000,120,10,42.5\r\n");
  EXPECT_EQ(r.rows.at(0).line, 4);
  EXPECT_FALSE(r.rows.at(0).readings[turning].value);
}

TEST(ReadRecords, an_empty_load_was_not_read) {
  const Record one = records(row("1,B,3000,120,10,42.5,")).rows.at(0);
  EXPECT_TRUE(one.readings[axial].value);
  EXPECT_FALSE(one.readings[turning].value);
}

struct Bad {
  const char* name;
  std::string text, message;
};
void PrintTo(const Bad& b, std::ostream* out) { *out << b.name; }

class BadRecords : public ::testing::TestWithParam<Bad> {};

TEST_P(BadRecords, are_rejected_with_line_and_column) {
  EXPECT_EQ(refusal(GetParam().text), GetParam().message);
}

std::string header_with(const std::string& from, const std::string& to) {
  std::string text = std::string(good_header) + good_row;
  return text.replace(text.find(from), from.size(), to);
}

const Bad mistakes[] = {
    {"unknown_column", header_with("tob [N m]", "tobb [N m]"),
     "FILE:1: tobb: found an unknown column, expected tob?"},
    {"column_of_another_subject", header_with("tob [N m]", "colour"),
     "FILE:1: colour: found an unknown column, expected one of test, bit, rock, pressure, "
     "rotary_speed, rate_of_penetration, wob, tob, wob_sd, tob_sd"},
    {"no_unit", header_with("wob [kN]", "wob"),
     "FILE:1: wob: found no unit, expected wob [unit], force in N or in another unit"},
    {"wrong_unit", header_with("wob [kN]", "wob [psi]"),
     "FILE:1: wob: found \"psi\" (psi is pressure), expected wob [unit], force in N or in another "
     "unit"},
    {"unit_that_is_none", header_with("wob [kN]", "wob [stones]"),
     "FILE:1: wob: found \"stones\" (unknown unit stones), expected wob [unit], force in N or "
     "in another unit"},
    {"unit_of_a_text", header_with("test", "test [m]"),
     "FILE:1: test: found a unit, expected a text, without a unit"},
    {"column_twice", header_with("tob [N m]", "wob [N]"),
     "FILE:1: wob: found the column twice, expected it once"},
    {"missing_column", header_with(",wob [kN]", ""),
     "FILE:1: wob: found no such column, expected it in the header"},
    {"nan", row("1,B,3000,120,10,nan,3100"), "FILE:2: wob: found nan, expected a number, > 0"},
    {"word", row("1,B,3000,fast,10,42.5,3100"),
     "FILE:2: rotary_speed: found fast, expected a number, > 0"},
    {"negative_load", row("1,B,3000,120,10,-42.5,3100"),
     "FILE:2: wob: found -42.5, expected a number, > 0"},
    {"load_of_zero", row("1,B,3000,120,10,42.5,0"), "FILE:2: tob: found 0, expected a number, > 0"},
    {"rate_of_zero", row("1,B,3000,120,0,42.5,3100"),
     "FILE:2: rate_of_penetration: found 0, expected a number, > 0"},
    {"negative_pressure", row("1,B,-1,120,10,42.5,3100"),
     "FILE:2: pressure: found -1, expected a number, >= 0"},
    {"no_pressure", row("1,B,,120,10,42.5,3100"),
     "FILE:2: pressure: found nothing, expected a number"},
    {"empty_name", row("1,,3000,120,10,42.5,3100"), "FILE:2: bit: found nothing, expected a name"},
    {"empty_test", row(",B,3000,120,10,42.5,3100"), "FILE:2: test: found nothing, expected a name"},
    {"row_twice", row("1,B,3000,120,10,42.5,3100\n1,B,3000,120,10,42.5,3100"),
     "FILE:3: row: found line 2 again, expected each reading once; a repeat is a test of its own "
     "name"},
    {"too_few_cells", row("1,B,3000,120,10,42.5"),
     "FILE:2: row: found 6 cells, expected 7, as in the header"},
    {"no_rows", good_header,
     "FILE:1: records: found no rows, expected a header and a row for each reading"},
    {"nothing", "", "FILE:1: records: found no rows, expected a header and a row for each reading"},
    {"all_mistakes_at_once", row(",B,3000,120,10,nan,3100\n2,,3000,120,10,1,-1"),
     "FILE:2: test: found nothing, expected a name\n"
     "FILE:2: wob: found nan, expected a number, > 0\n"
     "FILE:3: bit: found nothing, expected a name\n"
     "FILE:3: tob: found -1, expected a number, > 0"},
};

INSTANTIATE_TEST_SUITE_P(One, BadRecords, ::testing::ValuesIn(mistakes),
                         [](const auto& one) { return std::string(one.param.name); });

/// All mistakes of a header at once, also those behind a name that is none.
TEST(ReadRecords, an_unknown_column_hides_no_mistake_behind_it) {
  const std::string found = refusal(
      "test,bit,speed [m/s],pressure [psi],rotary_speed [rpm],wob\nB-1,B,1,3000,120,42.5\n");
  EXPECT_NE(found.find("FILE:1: speed: found an unknown column"), std::string::npos);
  EXPECT_NE(found.find("FILE:1: wob: found no unit"), std::string::npos) << found;
}

TEST(ReadRecords, a_file_that_is_not_there_is_rejected) {
  EXPECT_THROW(read_records(temporary_folder() + "absent.csv"), InputError);
}

}  // namespace
}  // namespace tdbd::calibration::read_records_test
