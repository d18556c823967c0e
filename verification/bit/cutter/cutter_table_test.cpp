#include "bit/cutter/cutter_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "bit/cutter/cutter_columns.hpp"
#include "bit/generate_design.hpp"
#include "core/error.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::bit::cutter_table_test {

constexpr const char* header =
    "bit,cutter,blade,zone,dia_mm,r_tip_mm,phi_deg,h_tip_mm,profile_angle_deg,back_rake_deg,"
    "side_rake_deg";
constexpr const char* good_row = "X,1,2,nose,19,50,90,3,10,15,2";

/// A file of its own for each test, gone at its end.
class CutterTable : public testing::Test {
 protected:
  ~CutterTable() override { std::filesystem::remove(path); }

  std::vector<Cutter> read(const std::string& text) const {
    std::ofstream(path) << text;
    return read_cutter_table(path, {});
  }
  /// The message, with the file's path left out.
  std::string mistakes(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      std::string message = error.what();
      for (auto at = message.find(path); at != std::string::npos; at = message.find(path))
        message.erase(at, path.size());
      return message;
    }
    return "";
  }
  std::string mistakes_of_row(const std::string& row) const {
    return mistakes(std::string(header) + "\n" + row + "\n");
  }

  const std::string path = tdbd::temporary_folder() + "tdbd-" +
                           testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv";
};

TEST_F(CutterTable, is_read_in_si_units) {
  const Cutter c = read(std::string(header) + "\n" + good_row + "\n").at(0);
  EXPECT_EQ(c.id, 1);
  EXPECT_EQ(c.blade, 2);
  EXPECT_EQ(c.zone, "nose");
  EXPECT_EQ(c.line, 2);
  EXPECT_DOUBLE_EQ(c.diameter, 0.019);
  EXPECT_DOUBLE_EQ(c.tip_radius, 0.05);
  EXPECT_DOUBLE_EQ(c.azimuth, pi / 2);
  EXPECT_DOUBLE_EQ(c.tip_height, 0.003);
  EXPECT_DOUBLE_EQ(c.profile_angle, 10 * degree);
  EXPECT_DOUBLE_EQ(c.back_rake, 15 * degree);
  EXPECT_DOUBLE_EQ(c.side_rake, 2 * degree);
  EXPECT_EQ(c.chamfer, CutterDefaults{}.chamfer);
  EXPECT_LT((c.X_BC * tip_C(c) - Vec3(0, 0.05, -0.003)).norm(), 1e-16);
}

TEST_F(CutterTable, names_the_separators_of_a_table_with_another_one) {
  const auto with = [&](const std::string& separator) {
    std::string text = std::string(header) + "\n" + good_row + "\n";
    for (std::size_t at = 0; (at = text.find(',', at)) != std::string::npos; at += separator.size())
      text.replace(at, 1, separator);
    return mistakes(text);
  };
  const std::string of_bar =
      ":1: table: found one column, with '|' in its name, expected columns with a separator: a "
      "comma, a semicolon or a tab instead of '|'";
  EXPECT_EQ(with("|"), of_bar);
  EXPECT_EQ(with(" | "), of_bar);
  EXPECT_EQ(with(" "),
            ":1: table: found one column, with a space in its name, expected columns with a "
            "separator: a comma, a semicolon or a tab instead of a space");
  EXPECT_EQ(with(";"), "");
}

TEST_F(CutterTable, lets_optional_columns_override_the_defaults) {
  const Cutter c = read(std::string(header) + ",chamfer_mm,chamfer_deg,length_mm,table_mm\n" +
                        good_row + ",0.25,30,11,2.5\n")
                       .at(0);
  EXPECT_DOUBLE_EQ(c.chamfer, 0.25e-3);
  EXPECT_DOUBLE_EQ(c.chamfer_angle, 30 * degree);
  EXPECT_DOUBLE_EQ(c.length, 11e-3);
  EXPECT_DOUBLE_EQ(c.table_thickness, 2.5e-3);
}

/// A table without a chamfer, so that the depth of one does not decide.
TEST_F(CutterTable, takes_a_table_of_more_than_a_nanometre) {
  const auto with_table = [](const char* mm) {
    return std::string(header) + ",chamfer_mm,table_mm\n" + good_row + ",0," + mm + "\n";
  };
  EXPECT_DOUBLE_EQ(read(with_table("0.000002")).at(0).table_thickness, 2e-9);
  EXPECT_NE(mistakes(with_table("0.0000005")).find("a positive thickness"), std::string::npos);
}

TEST_F(CutterTable, skips_blank_lines_and_comments_and_takes_columns_in_any_order) {
  const auto cutters = read(
      "# a bit\n\nside_rake_deg,back_rake_deg,profile_angle_deg,h_tip_mm,phi_deg,r_tip_mm,dia_mm,"
      "zone,blade,cutter,bit\r\n2,15,10,3,90,50,19,nose,2,1,X\r\n");
  ASSERT_EQ(cutters.size(), 1u);
  EXPECT_DOUBLE_EQ(cutters[0].diameter, 0.019);
  EXPECT_EQ(cutters[0].line, 4);
}

TEST_F(CutterTable, names_every_mistake_at_once) {
  EXPECT_EQ(mistakes(std::string(header) + ",chamfer_mm\n" +  //
                     "X,1,1,nose,nineteen,50,90,3,10,15,2,0.4\n"
                     "X,1,1.5,nose,0,-1,90,3,110,-6,nan,0.4\n"
                     "X,3,1,nose,19,60,90,3,10,15,2,9.5\n"
                     "X,4,1,nose,19,60,90,3,10,15,2,0.4\n"
                     "X,5,1,nose\n"),
            ":2: dia_mm: found 'nineteen', expected a number\n"
            ":3: blade: found '1.5', expected a whole number\n"
            ":3: side_rake_deg: found 'nan', expected a number\n"
            ":4: chamfer_mm: found 9.5, expected less than the cutter's radius, 9.5\n"
            ":6: row: found 4 cells, expected 12, as in the header\n"
            ":3: dia_mm: found 0, expected a positive diameter\n"
            ":3: r_tip_mm: found -1, expected a radius >= 0\n"
            ":3: profile_angle_deg: found 110, expected an angle in -90..100\n"
            ":3: back_rake_deg: found -6, expected an angle in -5..60\n"
            ":3: cutter: found 1, as in line 2, expected a number of its own\n"
            ":5: r_tip_mm, phi_deg, h_tip_mm: found the tip of line 4, expected a tip of its own");
}

TEST_F(CutterTable, takes_a_land_only_behind_a_steeper_chamfer) {
  const auto with_land = [&](const std::string& chamfer, const std::string& land_angle) {
    return std::string(header) + ",chamfer_mm,chamfer_deg,land_mm,land_deg\n" + good_row + "," +
           chamfer + ",45,0.3," + land_angle + "\n";
  };
  EXPECT_DOUBLE_EQ(read(with_land("0.4", "70")).at(0).land_angle, 70 * degree);
  for (const char* steep : {"45", "30"})
    EXPECT_EQ(mistakes(with_land("0.4", steep)),
              std::string(":2: land_deg: found ") + steep +
                  ", expected a land flatter than its chamfer: more than 45");
  EXPECT_EQ(mistakes(with_land("0", "70")),
            ":2: land_deg: found 70, expected a land flatter than its chamfer: more than 90");
}

TEST_F(CutterTable, names_missing_unknown_and_repeated_columns) {
  EXPECT_EQ(mistakes("bit,cutter,blade,zone,dia_mm,dia_mm,r_tip_mm,phi_deg,h_tip_mm,color,"
                     "profile_angle_deg,side_rake_deg\nX,1,1,nose,19,19,50,90,3,red,10,2\n"),
            ":1: dia_mm: found the column twice, expected it once\n"
            ":1: color: found an unknown column, expected one of bit, cutter, blade, zone, dia_mm, "
            "r_tip_mm, phi_deg, h_tip_mm, profile_angle_deg, back_rake_deg, side_rake_deg, "
            "chamfer_mm, chamfer_deg, length_mm, table_mm, land_mm, land_deg, wear_mm, "
            "under_exposure_mm, or note\n"
            ":1: back_rake_deg: found no such column, expected it in the header");
}

TEST_F(CutterTable, accepts_other_units_and_spellings) {
  const Cutter c = read(
                       "Cutter;BLADE;Zone;dia [in];R tip (cm);phi_rad;h_tip_m;Profile-angle_deg;"
                       "back_rake_deg;side_rake_deg;Notes\n"
                       "\n;;;;;;;;;;\n"
                       "1;2;nose;0,75;5,0;1,5707963267948966;3e-3;10;15;2,0;\"a; b\"\n")
                       .at(0);
  EXPECT_DOUBLE_EQ(c.diameter, 0.75 * 0.0254);
  EXPECT_DOUBLE_EQ(c.tip_radius, 0.05);
  EXPECT_DOUBLE_EQ(c.azimuth, 0.5 * pi);
  EXPECT_DOUBLE_EQ(c.tip_height, 3e-3);
  EXPECT_DOUBLE_EQ(c.side_rake, 2 * degree);
  EXPECT_EQ(c.line, 4);
}

TEST_F(CutterTable, suggests_columns_and_units) {
  const auto with_header = [&](const char* from, const char* to) {
    std::string text = std::string(header) + "\n" + good_row + "\n";
    const std::string mistake =
        mistakes(text.replace(text.find(from), std::string(from).size(), to));
    return mistake.substr(0, mistake.find('\n'));
  };
  EXPECT_EQ(with_header("r_tip_mm", "r_tip_ft"),
            ":1: r_tip_ft: found the unit \"ft\", expected mm, cm, m or in at the end of the name, "
            "as in r_tip_mm");
  EXPECT_EQ(with_header("phi_deg", "phi_mm"),
            ":1: phi_mm: found the unit \"mm\", expected deg or rad at the end of the name, as in "
            "phi_deg");
  EXPECT_EQ(with_header("h_tip_mm", "h_tip"),
            ":1: h_tip: found a column without a unit, expected mm, cm, m or in at the end of the "
            "name, as in h_tip_mm");
  EXPECT_EQ(with_header("back_rake_deg", "backrake_deg"),
            ":1: backrake_deg: found an unknown column, expected back_rake_deg");
  EXPECT_EQ(with_header("dia_mm", "Diameter [mm]"),
            ":1: diameter_mm: found an unknown column, expected dia_mm");
  EXPECT_EQ(
      with_header("side_rake_deg", "side_rake_deg,exposure_mm"),
      ":1: exposure_mm: found a column of exposures, expected under_exposure_mm here, exposure "
      "in the bit file's [blades]");
}

TEST_F(CutterTable, suspects_decimal_commas_and_missing_points) {
  EXPECT_EQ(mistakes_of_row("X,1,2,nose,19,50,5,90,3,10,15,2"),
            ":2: row: found 12 cells (decimal commas? Then separate the columns with semicolons), "
            "expected 11, as in the header");
  EXPECT_EQ(mistakes_of_row("X,1,2,nose,19,50144,90,3,10,15,2"),
            ":2: r_tip_mm: found 50144, expected at most 10000 mm: is the decimal point missing?");
}

TEST_F(CutterTable, rejects_a_workbook) {
  EXPECT_EQ(mistakes(std::string("PK\x03\x04", 4) + "..."),
            ":1: table: found a workbook of a spreadsheet program, expected a CSV table: save the "
            "sheet as \"CSV UTF-8\" (Excel: File, Save As; LibreOffice: File, Save As, Text CSV)");
}

TEST_F(CutterTable, lists_its_columns) {
  const KeyTable keys = cutter_table_keys();
  ASSERT_EQ(keys.rows.size(), 19u);
  EXPECT_EQ(keys.rows[1].name, "cutter");
  EXPECT_EQ(keys.rows[5].name, "r_tip_mm");
  EXPECT_EQ(keys.rows[5].fallback, "required");
  EXPECT_EQ(keys.rows[11].fallback, "cutters.chamfer");
}

TEST_F(CutterTable, rejects_half_numbers) {
  EXPECT_EQ(mistakes_of_row("X,1,2,nose,19mm,50,90,3,10,15,2"),
            ":2: dia_mm: found '19mm', expected a number");
  EXPECT_EQ(mistakes_of_row("X,1,2,nose,,50,90,3,10,15,2"),
            ":2: dia_mm: found '', expected a number");
}

TEST_F(CutterTable, must_contain_a_cutter) {
  const char* expected = ":1: table: found no cutter, expected a header and at least one cutter";
  EXPECT_EQ(mistakes(""), expected);
  EXPECT_EQ(mistakes(header), expected);
}

TEST_F(CutterTable, must_exist) {
  EXPECT_THROW(read_cutter_table(path + ".missing", {}), InputError);
}

TEST(ExampleTables, have_their_counts) {
  EXPECT_EQ(table('a').size(), 36u);
  EXPECT_EQ(table('b').size(), 28u);
  EXPECT_EQ(table('c').size(), 58u);
}

std::vector<Cutter> written_and_read(const std::vector<Cutter>& cutters) {
  const std::string path = tdbd::temporary_folder() + "tdbd-cutter-table-text.csv";
  std::ofstream(path) << cutter_table_text("bit", cutters);
  std::vector<Cutter> again = read_cutter_table(path, {});
  std::filesystem::remove(path);
  return again;
}

/// Every number of a cutter that a table holds.
constexpr std::array numbers{
    &Cutter::diameter,      &Cutter::tip_radius,      &Cutter::azimuth,       &Cutter::tip_height,
    &Cutter::profile_angle, &Cutter::back_rake,       &Cutter::side_rake,     &Cutter::chamfer,
    &Cutter::chamfer_angle, &Cutter::length,          &Cutter::land,          &Cutter::land_angle,
    &Cutter::wear,          &Cutter::table_thickness, &Cutter::under_exposure};

/// To the last bit: labels, sizes and poses.
bool same(const Cutter& a, const Cutter& b) {
  for (const auto number : numbers)
    if (a.*number != b.*number) return false;
  return a.id == b.id && a.blade == b.blade && a.zone == b.zone && a.X_BC.p == b.X_BC.p &&
         a.X_BC.R == b.X_BC.R;
}

RC_GTEST_PROP(CutterTableText, keeps_every_bit_of_a_generated_table, ()) {
  const std::vector<Cutter> cutters = laid_out(any_design());
  const std::vector<Cutter> again = written_and_read(cutters);
  RC_ASSERT(cutters.size() == again.size());
  for (std::size_t k = 0; k < cutters.size(); ++k) RC_ASSERT(same(cutters[k], again[k]));
}

/// Their lengths come from a default that no number of millimetres gives; the first table rounds
/// it.
TEST(CutterTableText, keeps_every_bit_of_the_example_tables_once_written) {
  for (const char letter : {'a', 'b', 'c'}) {
    const std::vector<Cutter> cutters = written_and_read(table(letter));
    const std::vector<Cutter> again = written_and_read(cutters);
    ASSERT_EQ(cutters.size(), again.size());
    for (std::size_t k = 0; k < cutters.size(); ++k) EXPECT_TRUE(same(cutters[k], again[k])) << k;
  }
}

}  // namespace tdbd::bit::cutter_table_test
