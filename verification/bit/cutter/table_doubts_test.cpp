#include "bit/cutter/table_doubts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "bit/files/bit_reading.hpp"
#include "bit/generate_design.hpp"
#include "core/config/csv.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::bit::table_doubts_test {

/// The cells of bit B's table. A wrong table is made from them.
using Rows = std::vector<std::vector<std::string>>;

enum Column {
  cutter = 1,
  blade,
  zone,
  dia,
  r_tip,
  phi,
  h_tip,
  profile_angle,
  back_rake,
  side_rake
};

Rows bit_b() {
  Rows rows;
  for (const CsvRow& row : read_csv_rows(TDBD_SOURCE_DIR "/cases/bits/bit-b.csv"))
    rows.push_back(row.cells);
  return rows;
}

void scale(Rows& rows, Column column, double by) {
  for (std::size_t k = 1; k < rows.size(); ++k)
    rows[k][column] = fmt::format("{:.6g}", by * std::stod(rows[k][column]));
}

void exchange(Rows& rows, Column a, Column b) {
  for (std::size_t k = 1; k < rows.size(); ++k) std::swap(rows[k][a], rows[k][b]);
}

void add_column(Rows& rows, const char* name, const char* value) {
  for (auto& row : rows) row.push_back(&row == &rows.front() ? name : value);
}

/// Errors, or warnings with "warning: " before them, of a bit with this table; TABLE and BIT stand
/// for the files.
std::string messages(const Rows& rows, const std::string& gage = "8.5 in",
                     const std::string& more = "") {
  const std::string folder = tdbd::temporary_folder(), table = folder + "doubts.csv",
                    file = folder + "doubts.toml";
  std::ofstream csv(table);
  for (const auto& row : rows) csv << fmt::format("{}\n", fmt::join(row, ","));
  csv.close();
  std::ofstream(file) << "name = \"b\"\ntable = \"doubts.csv\"\n"
                      << (gage.empty() ? "" : "gage_diameter = \"" + gage + "\"\n") << more;
  std::string text;
  try {
    for (const BitDoubt& d : read_bit(file, DirectionRule::hybrid, InsideRule::down).doubts)
      text += fmt::format("warning: {}: {}\n", d.place, d.text);
  } catch (const InputError& e) {
    text = fmt::format("{}\n", e.what());
  }
  for (const auto& [path, name] : {std::pair(table, "TABLE"), {file, "BIT"}})
    for (auto at = text.find(path); at != std::string::npos; at = text.find(path))
      text.replace(at, path.size(), name);
  return text;
}

struct WrongTable {
  const char* name;
  std::function<void(Rows&)> spoil;
  const char* message;
};

const std::vector<WrongTable>& wrong_tables() {
  static const std::vector<WrongTable> tables{
      {"the sign of a height in the cone", [](Rows& r) { r[5][h_tip] = "-6.167"; },
       "TABLE:6: h_tip_mm: found -6.167 mm of cutter 5, expected about 6.17 mm (is the sign "
       "wrong?), between cutters 4 and 6 of the profile\n"},
      {"the sign of a height on the shoulder", [](Rows& r) { r[20][h_tip] = "-37.236"; },
       "TABLE:21: h_tip_mm: found -37.236 mm of cutter 20, expected about 37.2 mm (is the sign "
       "wrong?), between cutters 19 and 21 of the profile\n"},
      {"the sign of a small height", [](Rows& r) { r[8][h_tip] = "-0.436"; },
       "warning: TABLE:9: h_tip_mm: found -0.436 mm of cutter 8, expected about 0.436 mm (is the "
       "sign wrong?), between cutters 7 and 9 of the profile\n"},
      {"the sign of a profile angle in the cone", [](Rows& r) { r[3][profile_angle] = "15"; },
       "warning: TABLE:4: profile_angle_deg: found 15 deg of cutter 3, expected about -15 deg (is "
       "the sign wrong?), between cutters 2 and 4 of the profile\n"},
      {"the sign of a profile angle on the nose", [](Rows& r) { r[9][profile_angle] = "-3.618"; },
       "warning: TABLE:10: profile_angle_deg: found -3.618 deg of cutter 9, expected about 3.62 "
       "deg (is the sign wrong?), between cutters 8 and 10 of the profile\n"},
      {"the sign of a profile angle on the shoulder",
       [](Rows& r) { r[14][profile_angle] = "-44.34"; },
       "TABLE:15: profile_angle_deg: found -44.34 deg of cutter 14, expected about 44.3 deg (is "
       "the sign wrong?), between cutters 13 and 15 of the profile\n"},
      {"the sign of a side rake", [](Rows& r) { r[20][side_rake] = "-4.002"; },
       "warning: TABLE:21: side_rake_deg: found -4.002 deg of cutter 20, expected about 4 deg (is "
       "the sign wrong?), like its neighbours on the profile, cutters 19 and 21\n"},
      {"a back rake of 42 in place of 12", [](Rows& r) { r[4][back_rake] = "42"; },
       "warning: TABLE:5: back_rake_deg: found 42 deg of cutter 4, expected about 12 deg, like its "
       "neighbours on the profile, cutters 3 and 5\n"},
      {"a radius typo in the cone", [](Rows& r) { r[5][r_tip] = "43.508"; },
       "warning: TABLE:6: r_tip_mm: found 43.508 mm of cutter 5, expected about 34.5 mm, between "
       "cutters 4 and 6 of the profile\n"},
      {"a radius typo on the nose", [](Rows& r) { r[9][r_tip] = "61.146"; },
       "warning: TABLE:10: r_tip_mm: found 61.146 mm of cutter 9, expected about 64 mm, between "
       "cutters 8 and 10 of the profile\n"},
      {"two digits of a radius on the nose", [](Rows& r) { r[9][r_tip] = "46.146"; },
       "warning: TABLE:10: r_tip_mm: found 46.146 mm of cutter 9, expected about 64 mm, between "
       "cutters 8 and 10 of the profile\n"},
      {"half a diameter off the profile",
       [](Rows& r) {
         r[14][r_tip] = "96.7";
         r[14][h_tip] = "6.27";
       },
       "TABLE:15: r_tip_mm, h_tip_mm, profile_angle_deg: found the tip of cutter 14 9.5 mm off the "
       "profile of the others, with a profile angle of 44.34 deg, expected a tip on it, between "
       "cutters 13 and 15 of the profile; under_exposure_mm marks back-up cutters\n"},
      {"a missing decimal point", [](Rows& r) { r[12][r_tip] = "80812"; },
       "TABLE:13: r_tip_mm: found 80812, expected at most 10000 mm: is the decimal point "
       "missing?\n"},
      {"a decimal point at another place", [](Rows& r) { r[12][r_tip] = "808.12"; },
       "TABLE:13: r_tip_mm: found 808.12 mm of cutter 12, expected about 80.8 mm, between cutters "
       "11 and 13 of the profile\n"},
      {"a missing row", [](Rows& r) { r.erase(r.begin() + 9); },
       "warning: TABLE:10: r_tip_mm: found a gap of 13.4 mm on the profile between cutters 8 and "
       "10, expected cutter 9 between them; is its row missing?\n"},
      {"a row twice", [](Rows& r) { r.insert(r.begin() + 9, r[9]); },
       "TABLE:11: cutter: found 9, as in line 10, expected a number of its own\n"
       "TABLE:11: r_tip_mm, phi_deg, h_tip_mm: found the tip of line 10, expected a tip of its "
       "own\n"},
      {"an azimuth of another blade", [](Rows& r) { r[16][phi] = "169.231"; },
       "warning: TABLE:17: phi_deg: found 169.2 deg of cutter 16, expected about 350 deg, like "
       "cutters 11 and 21 of its blade 1; or another blade\n"},
      {"all heights downwards", [](Rows& r) { scale(r, h_tip, -1.0); },
       "TABLE:2: h_tip_mm: found heights that decrease towards the gage, expected heights above "
       "the nose, positive towards the shank: change the sign of the column\n"},
      {"all profile angles of the other sign", [](Rows& r) { scale(r, profile_angle, -1.0); },
       "TABLE:2: profile_angle_deg: found angles of the opposite sign of the profile's slope, "
       "expected negative angles in the cone, 90 on the gage: change the sign of the column\n"},
      {"profile angles in rad", [](Rows& r) { scale(r, profile_angle, degree); },
       "TABLE:2: profile_angle_deg: found angles that fit the profile in rad, expected deg, or the "
       "name profile_angle_rad\n"},
      {"all angles in rad",
       [](Rows& r) {
         for (const Column c : {phi, profile_angle, back_rake, side_rake}) scale(r, c, degree);
       },
       "TABLE:2: profile_angle_deg: found angles that fit the profile in rad, expected deg, or the "
       "name profile_angle_rad\n"
       "TABLE:2: phi_deg: found azimuths of at most 6.27 deg, expected cutters around the axis; "
       "are angles in rad (phi_rad)?\n"
       "TABLE:2: back_rake_deg: found back rakes of at most 0.436 deg, expected usually 5 to 30 "
       "deg; are angles in rad (back_rake_rad)?\n"},
      {"lengths in inches",
       [](Rows& r) {
         for (const Column c : {dia, r_tip, h_tip}) scale(r, c, 1 / 25.4);
       },
       "TABLE:2: r_tip_mm: found a bit of 8.5 mm, expected 20 to 1200 mm; are lengths in inches "
       "(then name the column r_tip_in)?\n"},
      {"radii in inches", [](Rows& r) { scale(r, r_tip, 1 / 25.4); },
       "TABLE:2: r_tip_mm: found a bit of 8.5 mm, expected 20 to 1200 mm; are lengths in inches "
       "(then name the column r_tip_in)?\n"},
      {"diameters for radii", [](Rows& r) { scale(r, r_tip, 2.0); },
       "TABLE:2: r_tip_mm: found values that fit the profile as diameters, expected radii: half of "
       "these\n"},
      {"radius and height exchanged", [](Rows& r) { exchange(r, r_tip, h_tip); },
       "TABLE:2: r_tip_mm, h_tip_mm: found values that fit the profile when swapped, expected the "
       "radius in r_tip_mm, the height in h_tip_mm\n"},
      {"diameter and radius exchanged", [](Rows& r) { exchange(r, dia, r_tip); },
       "TABLE:2: dia_mm, r_tip_mm: found values that fit the profile when swapped, expected the "
       "diameter of the cutter in dia_mm, the radius of its tip in r_tip_mm\n"},
      {"the signs of all side rakes", [](Rows& r) { scale(r, side_rake, -1.0); },
       "warning: TABLE:2: side_rake_deg: found side rakes of -4.74 to 0 deg, expected usually 0 to "
       "10 deg, which send cuttings outwards; is the sign of the column wrong?\n"},
      {"the rakes exchanged", [](Rows& r) { exchange(r, back_rake, side_rake); },
       "TABLE:2: back_rake_deg, side_rake_deg: found side rakes of about 16.4 deg and back rakes "
       "of "
       "about 0.756 deg, expected back rakes larger than side rakes; are the columns swapped?\n"},
      {"smaller rakes exchanged",
       [](Rows& r) {
         for (std::size_t k = 1; k < r.size(); ++k) r[k][side_rake] = "7";
         exchange(r, back_rake, side_rake);
       },
       "warning: TABLE:2: back_rake_deg, side_rake_deg: found side rakes of about 16.4 deg and "
       "back "
       "rakes of about 7 deg, expected back rakes larger than side rakes; are the columns "
       "swapped?\n"},
      {"all back rakes negative", [](Rows& r) { scale(r, back_rake, -1.0); },
       "TABLE:2: back_rake_deg: found -12 and 27 more values outside the range, expected an angle "
       "in -5..60: positive rakes lean back; change the sign of the column, or are back and side "
       "rakes swapped?\n"},
      {"lengths in cm",
       [](Rows& r) {
         for (const Column c : {dia, r_tip, h_tip}) scale(r, c, 0.1);
       },
       "TABLE:2: r_tip_mm: found a bit of 21.59 mm with cutters of 1.9 mm, expected cutters of 3 "
       "to "
       "60 mm; are lengths in cm (then name the column r_tip_cm)?\n"},
      {"lengths in m",
       [](Rows& r) {
         for (const Column c : {dia, r_tip, h_tip}) scale(r, c, 1e-3);
       },
       "TABLE:2: r_tip_mm: found a bit of 0.2159 mm, expected 20 to 1200 mm; are lengths in m "
       "(then "
       "name the column r_tip_m)?\n"},
      {"mm in columns of inches",
       [](Rows& r) {
         r[0][dia] = "dia_in";
         r[0][r_tip] = "r_tip_in";
         r[0][h_tip] = "h_tip_in";
       },
       "TABLE:2: r_tip_mm: found a bit of 5484 mm, expected 20 to 1200 mm; are lengths in mm (then "
       "name the column r_tip_mm)?\n"},
      {"a large bit in inches",
       [](Rows& r) {
         for (const Column c : {dia, r_tip, h_tip}) scale(r, c, 4.0 / 25.4);
         scale(r, dia, 0.25);
       },
       "TABLE:2: r_tip_mm: found a bit of 34 mm with cutters of 0.748 mm, expected cutters of 3 "
       "to 60 mm; are lengths in inches (then name the column r_tip_in)?\n"},
      {"the profile of a large bit in inches",
       [](Rows& r) {
         for (const Column c : {r_tip, h_tip}) scale(r, c, 4.0 / 25.4);
       },
       "TABLE:2: r_tip_mm: found a bit of 34 mm with 28 cutters of 19 mm, expected a bit wider "
       "than "
       "its cutters; are lengths in inches (then name the column r_tip_in)?\n"},
      {"diameters in inches", [](Rows& r) { scale(r, dia, 1 / 25.4); },
       "warning: TABLE:2: dia_mm: found cutters of 0.748 mm, expected 3 to 60 mm; are diameters in "
       "inches (dia_in)?\n"},
      {"one diameter in inches", [](Rows& r) { r[7][dia] = "0.748"; },
       "warning: TABLE:8: dia_mm: found 0.748 mm of cutter 7, expected about 19 mm, like the "
       "others; "
       "is this row in inches?\n"},
      {"chamfers in inches", [](Rows& r) { add_column(r, "chamfer_mm", "0.018"); },
       "warning: TABLE:2: chamfer_mm: found at most 0.018 mm, expected usually 0.08 to 4 mm; are "
       "lengths in inches (then name the column chamfer_in)?\n"},
      {"lengths of cutters in inches",
       [](Rows& r) {
         add_column(r, "length_mm", "0.52");
         add_column(r, "table_mm", "0.08");
       },
       "warning: TABLE:2: length_mm: found at most 0.52 mm, expected usually 2 to 80 mm; are "
       "lengths "
       "in inches (then name the column length_in)?\n"
       "warning: TABLE:2: table_mm: found at most 0.08 mm, expected usually 0.3 to 12 mm; are "
       "lengths in inches (then name the column table_in)?\n"},
      {"decimal commas between commas", [](Rows& r) { r[3][r_tip] = "19,826"; },
       "TABLE:4: row: found 12 cells (decimal commas? Then separate the columns with semicolons), "
       "expected 11, as in the header\n"},
      {"an unknown unit", [](Rows& r) { r[0][r_tip] = "r_tip_ft"; },
       "TABLE:1: r_tip_ft: found the unit \"ft\", expected mm, cm, m or in at the end of the name, "
       "as in r_tip_mm\n"
       "TABLE:1: r_tip_mm: found no such column, expected it in the header\n"},
      {"no unit", [](Rows& r) { r[0][h_tip] = "h_tip"; },
       "TABLE:1: h_tip: found a column without a unit, expected mm, cm, m or in at the end of the "
       "name, as in h_tip_mm\n"
       "TABLE:1: h_tip_mm: found no such column, expected it in the header\n"},
      {"a name of another program", [](Rows& r) { r[0][phi] = "azimuth"; },
       "TABLE:1: azimuth: found an unknown column, expected phi_deg\n"
       "TABLE:1: phi_deg: found no such column, expected it in the header\n"},
  };
  return tables;
}

TEST(WrongTable, is_reported_at_its_row) {
  for (const WrongTable& wrong : wrong_tables()) {
    Rows rows = bit_b();
    wrong.spoil(rows);
    const std::string expected = wrong.message, found = messages(rows);
    EXPECT_EQ(found.substr(0, expected.size()), expected) << wrong.name;
    // Rakes of the wrong column also turn cutters out of the gage, which is reported after them.
    if (found.find("reaching") == std::string::npos) {
      EXPECT_EQ(found, expected) << wrong.name;
    }
  }
}

/// Neighbours decide, not the digits: tables rounded to 0.1 mm and a degree raise no doubts.
TEST(TableDoubts, are_none_about_the_tables_of_the_cases) {
  for (const char* name : {"bit-a", "bit-b", "bit-c", "standard", "core", "new/cutters"}) {
    std::vector<Cutter> cutters =
        read_cutter_table(fmt::format(TDBD_SOURCE_DIR "/cases/bits/{}.csv", name), {});
    const auto texts = [&] {
      std::string text;
      for (const TableDoubt& d : table_doubts(cutters)) text += doubt_text(name, d) + "\n";
      return text;
    };
    EXPECT_EQ(texts(), "");
    for (Cutter& c : cutters) {
      c.tip_radius = 1e-4 * std::round(c.tip_radius / 1e-4);
      c.tip_height = 1e-4 * std::round(c.tip_height / 1e-4);
      c.profile_angle = degree * std::round(c.profile_angle / degree);
    }
    EXPECT_EQ(texts(), "") << "rounded";
  }
}

/// Every sign error in a height of more than 0.3 mm or an angle of more than 2.6 degrees.
TEST(TableDoubts, find_every_wrong_sign) {
  for (const char letter : {'a', 'b', 'c'})
    for (const auto member : {&Cutter::tip_height, &Cutter::profile_angle}) {
      const bool is_height = member == &Cutter::tip_height;
      const std::vector<Cutter> good = table(letter);
      for (std::size_t k = 0; k < good.size(); ++k) {
        if (std::abs(good[k].*member) < (is_height ? 0.3e-3 : 2.6 * degree)) continue;
        std::vector<Cutter> wrong = good;
        wrong[k].*member = -(wrong[k].*member);
        const std::vector<TableDoubt> doubts = table_doubts(wrong);
        ASSERT_EQ(doubts.size(), 1u) << letter << k;
        EXPECT_EQ(doubts[0].line, good[k].line);
        EXPECT_EQ(doubts[0].column, is_height ? "h_tip_mm" : "profile_angle_deg");
      }
    }
}

RC_GTEST_PROP(TableDoubts, are_no_errors_about_generated_designs, ()) {
  const std::vector<Cutter> cutters = laid_out(any_design());
  for (const TableDoubt& d : table_doubts(cutters))
    if (d.severity == Severity::impossible) RC_FAIL(doubt_text("design", d));
}

/// Wrong rows that fit each other: four or all five cutters of the gage below the nose.
TEST(TableDoubts, find_several_wrong_signs_of_heights) {
  for (const char letter : {'a', 'b', 'c'})
    for (const std::size_t count : {2U, 4U, 5U}) {
      std::vector<Cutter> wrong = table(letter);
      const std::size_t first = wrong.size() - count;
      for (std::size_t k = first; k < wrong.size(); ++k) wrong[k].tip_height *= -1.0;
      const std::vector<TableDoubt> doubts = table_doubts(wrong);
      ASSERT_EQ(doubts.size(), count) << letter << count << doubt_text("t", doubts.front());
      for (std::size_t k = 0; k < count; ++k) {
        EXPECT_EQ(doubts[k].line, wrong[first + k].line);
        EXPECT_EQ(doubts[k].column, "h_tip_mm");
        EXPECT_NE(doubts[k].expected.find("is the sign wrong?"), std::string::npos);
      }
    }
}

TEST(TableDoubts, can_be_switched_off) {
  Rows rows = bit_b();
  rows[5][h_tip] = "-6.167";
  EXPECT_EQ(messages(rows, "", "table_check = \"off\"\n"), "");
}

TEST(TableDoubts, about_rows_come_before_what_they_cause) {
  Rows rows = bit_b();
  rows[3][profile_angle] = "15";
  const std::string message =
      messages(rows, "8.5 in", "[blades]\nexposure = \"8 mm\"\nslot_depth = \"60 mm\"\n");
  EXPECT_EQ(message.rfind("TABLE:4: profile_angle_deg: found 15 deg of cutter 3", 0), 0u)
      << message;
  EXPECT_NE(message.find("\nBIT:"), std::string::npos) << message;
}

/// 12.25 in, 8.5 m and radii of another bit beside the table of an 8.5 in bit.
TEST(GageDiameter, is_compared_with_the_outermost_tip) {
  const auto expected = [](const char* found) {
    return fmt::format(
        "gage_diameter: found {}, expected about 215.9 mm: the outermost tip of TABLE, cutter 24 "
        "in "
        "line 25, is at a radius of 107.95 mm\n",
        found);
  };
  EXPECT_EQ(messages(bit_b(), "12.25 in"), "BIT:3: " + expected("311.15 mm"));
  EXPECT_EQ(messages(bit_b(), "8.5 m"), "BIT:3: " + expected("8500 mm"));
  EXPECT_EQ(messages(bit_b(), "6 in"), "BIT:3: " + expected("152.4 mm"));
  EXPECT_EQ(messages(bit_b(), "8.875 in"), "warning: BIT:3: " + expected("225.425 mm"));
  EXPECT_EQ(messages(bit_b(), "8.75 in"), "warning: BIT:3: " + expected("222.25 mm"));
  EXPECT_EQ(messages(bit_b(), "8.5 in"), "");
  EXPECT_EQ(messages(bit_b(), ""), "");
}

}  // namespace tdbd::bit::table_doubts_test
