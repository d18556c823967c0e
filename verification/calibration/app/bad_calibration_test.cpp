#include <gtest/gtest.h>

#include "app/mistake.hpp"
#include "calibration/app/calibration_folder.hpp"

namespace tdbd::app::bad_calibration_test {
namespace {

/// Files of the folder: nothing else may be there after a refusal.
const std::vector<std::string> untouched{"case.toml", "records.csv"};

class BadCalibration : public ::testing::TestWithParam<Mistake> {};

TEST_P(BadCalibration, is_rejected_with_its_place_and_reason) {
  const Mistake& m = GetParam();
  const CalibrationFolder c;
  c.edit("case.toml", m.from, m.to);
  expect_refusal(c.calibrate(), c.path("case.toml").string() + ":" + m.message);
  EXPECT_EQ(files_below(c.path("")), untouched);
}

const Mistake mistakes[] = {
    {"predicted_bit_that_is_fitted", "predict_bits = [\"c16\"]", "predict_bits = [\"c13\"]",
     "5: calibration.predict_bits: found 'c13', which is fitted, expected bits that the fit does "
     "not see"},
    {"unknown_bit", "[\"c13\", \"c19\"]", "[\"c13\", \"c18\"]",
     "4: calibration.fit_bits: found 'c18', which is not in [bits] or [cutters], expected c13?"},
    {"bit_without_records", "[cutters.c13]", "[cutters.c99]",
     "4: calibration.fit_bits: found 'c13', which is not in [bits] or [cutters], expected c16?"},
    {"bit_to_predict_unknown", "predict_bits = [\"c16\"]", "predict_bits = [\"d16\"]",
     "5: calibration.predict_bits: found 'd16', which is not in [bits] or [cutters], expected "
     "c16?"},
    {"bit_without_a_record", "fit_bits = [\"c13\", \"c19\"]\npredict_bits = [\"c16\"]\n",
     "fit_bits = [\"c13\", \"c20\"]\npredict_bits = [\"c16\"]\n[cutters.c20]\nback_rake = "
     "0.3\ndiameter = \"20 "
     "mm\"\n",
     "4: calibration.fit_bits: found 'c20', of which there are no records, expected one of c13, "
     "c16, c19"},
    {"bit_twice", "[\"c13\", \"c19\"]", "[\"c13\", \"c13\"]",
     "4: calibration.fit_bits: found 'c13' twice, expected each name once"},
    {"no_bit", "[\"c13\", \"c19\"]", "[]",
     "4: calibration.fit_bits: found none, expected at least one bit or cutter: there are "
     "unknowns"},
    {"unknown_test", "[cutters.c13]", "leave_out = [\"c13-300\"]\n[cutters.c13]",
     "6: calibration.leave_out: found 'c13-300', a test without records, expected c13-3000?"},

    {"no_records", "records = \"records.csv\"\n", "",
     "1: calibration.records: found nothing, expected the path of an existing file, from the case "
     "file's folder (the key is required)"},

    {"unknown_coefficient", "[unknowns.A6]", "[unknowns.A66]",
     "29: unknowns.A66: found no coefficient of hanson-hansen, expected A6?"},
    {"fixed_stranger", "A4 = 0.5", "B4 = 0.5",
     "34: fixed.B4: found no coefficient of hanson-hansen, expected A4?"},
    {"free_and_fixed", "A4 = 0.5", "A6 = 0.5",
     "34: fixed.A6: found a value for what is fitted, expected it here or in [unknowns], not in "
     "both"},
    {"coefficient_without_value", "[unknowns.A1]\nstart = 1.0\n", "",
     "31: fixed.A1: found nothing, expected a plain number, >= 0 (the key is required)"},
    {"free_without_start", "[unknowns.A5]\nstart = 1.0\n", "[unknowns.A5]\n",
     "27: unknowns.A5.start: found nothing, expected a plain number (the key is required)"},
    {"start_on_an_end", "start = \"18 deg\"", "start = \"45 deg\"",
     "25: unknowns.A3.start: found 0.785398, expected a value between 0 and 0.785398"},
    {"start_out_of_range", "start = \"18 deg\"", "start = \"50 deg\"",
     "25: unknowns.A3.start: found 0.872665, expected a value between 0 and 0.785398"},
    {"start_in_a_wrong_unit", "start = \"18 deg\"", "start = \"18 mm\"",
     "25: unknowns.A3.start: found \"18 mm\" (mm is length), expected angle in rad or in another "
     "unit"},
    {"range_that_falls", "[\"0 deg\", \"45 deg\"]", "[\"45 deg\", \"0 deg\"]",
     "26: unknowns.A3.range: found [0.785398, 0], expected [lowest, highest], rising, within 0 and "
     "1"},
    {"range_beyond_the_laws", "[\"0 deg\", \"45 deg\"]", "[\"0 deg\", \"80 deg\"]",
     "26: unknowns.A3.range: found [0, 1.39626], expected [lowest, highest], rising, within 0 and "
     "1"},
    {"prior_of_no_width", "[fixed]", "prior_sd = 0\n[fixed]",
     "33: unknowns.pressure_share.prior_sd: found 0, expected a plain number, > 0"},
    {"spalling_of_no_angle", "[fixed]", "[spalling]\nangle = \"90 deg\"\n[fixed]",
     "34: spalling.angle: found 90 degrees, expected an angle in (0, 90) degrees"},
    {"spalling_under_pressure", "[fixed]",
     "[spalling]\nangle = \"60 deg\"\nup_to_pressure = \"1 MPa\"\n[fixed]",
     "35: spalling.up_to_pressure: found 1e+06 Pa and a record of c13 in rock confined by "
     "2.06843e+07 Pa, expected records at which rock breaks out, or no table [spalling]"},
    {"edge_and_its_stress", "[fixed]\nA4 = 0.5",
     "[unknowns.te]\nstart = 1e-4\n[unknowns.A4]\nstart = 1",
     "33: unknowns.te: found a direction that the records do not determine: te +100 %, A4 -100 %; "
     "expected a prior_sd for one of them, or one of them in [fixed]"},
    {"coefficient_of_no_part", "[fixed]", "[unknowns.A7]\nstart = 1\n[fixed]",
     "33: unknowns.A7: found a coefficient that acts on no part of the fitted bits (it acts on cse "
     "or cutter body), expected it in [fixed]"},
    {"noise_of_zero", "reading = 0.03", "reading = 0",
     "21: noise.reading: found 0, expected a plain number, > 0"},
    {"unknown_rock", "mancos-shale", "mancos-shail",
     "19: rock.material: found \"mancos-shail\", expected one of berea-sandstone, "
     "sierra-white-granite, mancos-shale, texas-granite, forge-granitoid, carthage-marble, "
     "crab-orchard-sandstone, catoosa-shale, indiana-limestone (did you mean mancos-shale?)"},
    {"unknown_key", "bootstrap = 20", "boot = 20",
     "36: intervals.boot: found an unknown key, expected intervals.seed"},
    {"cutter_of_no_diameter", "diameter = \"13 mm\"", "diameter = \"0 mm\"",
     "7: cutters.c13.diameter: found \"0 mm\", expected length in m, > 0"},
    {"name_with_a_comma", "[cutters.c16]",
     "[cutters.\"c,1\"]\ndiameter = 1\nback_rake = 0\n[cutters.c16]",
     "6: cutters: found the name 'c,1', expected letters, digits, - and _"},
    {"level_of_certainty", "bootstrap = 20", "level = 1.0",
     "36: intervals.level: found 1.0, expected a plain number, in [0.5, 0.999]"},
};

INSTANTIATE_TEST_SUITE_P(One, BadCalibration, ::testing::ValuesIn(mistakes),
                         [](const auto& one) { return std::string(one.param.name); });

/// A mistake in the records, and the message after the name of the file.
struct BadRow {
  const char *name, *from, *to, *message;
};
void PrintTo(const BadRow& b, std::ostream* out) { *out << b.name; }

class BadCalibrationRecords : public ::testing::TestWithParam<BadRow> {};

TEST_P(BadCalibrationRecords, are_rejected_with_their_line) {
  const BadRow& m = GetParam();
  const CalibrationFolder c;
  c.edit("records.csv", m.from, m.to);
  expect_refusal(c.calibrate(), c.path("records.csv").string() + ":" + m.message);
  EXPECT_EQ(files_below(c.path("")), untouched);
}

const BadRow bad_rows[] = {
    {"wrong_unit", "normal [N]", "normal [psi]",
     "1: normal: found \"psi\" (psi is pressure), expected normal [unit], force in N or in another "
     "unit"},
    {"unknown_column", "drag [N]", "drug [N]", "1: drug: found an unknown column, expected drag?"},
    {"speed_of_zero", "c13-3000,c13,3000,500", "c13-3000,c13,3000,0",
     "2: speed: found 0, expected a number, > 0"},
    {"load_that_is_no_number", "c13-3000,c13,3000,500,0.5,", "c13-3000,c13,3000,500,0.5,nan,",
     "2: row: found 8 cells, expected 7, as in the header"},
    {"row_twice", "c13-3000,c13,3000,500,0.5,",
     "a,a,1,1,1,1,1\na,a,1,1,1,1,1\nc13-3000,c13,3000,500,0.5,",
     "3: row: found line 2 again, expected each reading once; a repeat is a test of its own name"},
    {"row_of_two_cells", "c13-3000,c13,3000,500,0.5,", "a,b\nc13-3000,c13,3000,500,0.5,",
     "2: row: found 2 cells, expected 7, as in the header"},
};

INSTANTIATE_TEST_SUITE_P(One, BadCalibrationRecords, ::testing::ValuesIn(bad_rows),
                         [](const auto& one) { return std::string(one.param.name); });

enum class Drag { read, unread };

/// The rows of the records that hold a text, with or without their last column.
std::string records_with(const CalibrationFolder& c, const std::string& row, Drag drag) {
  std::istringstream in(read(c.path("records.csv")));
  std::string text, line;
  while (std::getline(in, line)) {
    if (line.rfind("test", 0) != 0 && line.find(row) == std::string::npos) continue;
    if (drag == Drag::unread) line = line.substr(0, line.rfind(','));
    text += line + "\n";
  }
  return text;
}

TEST(BadCalibration, a_share_of_pressure_at_one_pressure) {
  const CalibrationFolder c;
  c.write("records.csv", records_with(c, "3000,500", Drag::read));
  expect_refusal(
      c.calibrate(),
      c.path("case.toml").string() +
          ":31: unknowns.pressure_share: found one pressure, expected records at two pressures at "
          "least, fitted together: a test at another pressure, or the share in [fixed]");
  EXPECT_EQ(files_below(c.path("")), untouched);
}

TEST(BadCalibration, a_share_of_pressure_in_separate_fits) {
  const CalibrationFolder c;
  c.edit("case.toml", "[cutters.c13]", "pressures = \"separate\"\n[cutters.c13]");
  expect_refusal(c.calibrate(),
                 c.path("case.toml").string() +
                     ":32: unknowns.pressure_share: found a fit at each pressure alone, expected "
                     "records at two pressures at least, fitted together: a test at another "
                     "pressure, or the share in [fixed]");
}

TEST(BadCalibration, two_coefficients_of_a_face_without_torque) {
  const CalibrationFolder c;
  c.write("records.csv", records_with(c, "", Drag::unread));
  expect_refusal(
      c.calibrate(),
      c.path("case.toml").string() +
          ":24: unknowns.A3: found A1 and A3 free and no drag, expected a drag reading, a prior_sd "
          "for one of the two, or one of them in [fixed]: normal alone sees their product");
  EXPECT_EQ(files_below(c.path("")), untouched);
}

TEST(BadCalibration, fewer_readings_than_unknowns) {
  const CalibrationFolder c;
  c.write("records.csv", records_with(c, ",1.0,", Drag::read));
  c.edit("case.toml", "fit_bits = [\"c13\", \"c19\"]", "fit_bits = [\"c19\"]");
  expect_refusal(
      c.calibrate(),
      c.path("case.toml").string() +
          ":31: unknowns.pressure_share: found 4 readings and 0 priors for 5 unknowns, expected as "
          "many at least: more records, a prior_sd, or coefficients moved to [fixed]");
  EXPECT_EQ(files_below(c.path("")), untouched);
}

/// A prior counts as much as a reading.
TEST(BadCalibration, readings_and_priors_together_are_enough) {
  const CalibrationFolder c;
  c.write("records.csv", records_with(c, ",1.0,", Drag::read));
  c.edit("case.toml", "fit_bits = [\"c13\", \"c19\"]", "fit_bits = [\"c19\"]");
  c.edit("case.toml", "[fixed]", "prior_sd = 0.2\n[fixed]");
  EXPECT_EQ(c.calibrate().err.find("for 5 unknowns"), std::string::npos) << c.calibrate().err;
}

TEST(BadCalibration, records_of_bits_for_cutters) {
  const CalibrationFolder c;
  c.write("records.csv",
          "test,bit,pressure [psi],rotary_speed [rpm],rate_of_penetration [m/h],wob [kN]\n"
          "1,c13,3000,120,10,42.5\n2,c16,3000,120,10,42.5\n3,c19,3000,120,10,42.5\n");
  expect_refusal(c.calibrate(), c.path("case.toml").string() +
                                    ":3: calibration.records: found tests of another kind than "
                                    "'c13', expected a column bit for bits, a column cutter for "
                                    "cutters");
}

TEST(BadCalibration, records_that_are_not_there) {
  const CalibrationFolder c;
  c.edit("case.toml", "records.csv", "absent.csv");
  expect_refusal(c.calibrate(),
                 c.path("case.toml").string() +
                     ":3: calibration.records: found \"absent.csv\" (there is no " +
                     c.path("absent.csv").string() +
                     "), expected the path of an existing file, from the case file's folder");
}

TEST(BadCalibration, rejects_an_unknown_rock) {
  const CalibrationFolder c;
  c.write("records.csv",
          "test,cutter,speed [mm/s],depth [mm],normal [N],rock\n1,c13,500,1,300,mancos-shail\n"
          "1,c16,500,1,300,\n1,c19,500,1,300,\n");
  const auto o = c.calibrate();
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_EQ(o.err.rfind("tdbd: " + c.path("records.csv").string() + ":2: rock: ", 0), 0u) << o.err;
  EXPECT_NE(o.err.find("mancos-shail"), std::string::npos) << o.err;
}

TEST(BadCalibration, all_mistakes_at_once) {
  const CalibrationFolder c;
  c.edit("case.toml", "start = \"18 deg\"", "start = \"50 deg\"");
  c.edit("case.toml", "bootstrap", "bootstraps");
  c.edit("records.csv", "500,0.5", "500,-0.5");
  const std::string at = c.path("case.toml").string();
  expect_refusal(c.calibrate(),
                 at +
                     ":25: unknowns.A3.start: found 0.872665, expected a value between 0 and "
                     "0.785398\n" +
                     at + ":36: intervals.bootstraps: found an unknown key, expected bootstrap\n" +
                     c.path("records.csv").string() +
                     ":2: depth: found -0.5, expected a number, > 0");
  EXPECT_EQ(files_below(c.path("")), untouched);
}

/// A valid calibration overwrites nothing either, and fails before it starts to compute.
TEST(BadCalibration, a_folder_that_is_in_use) {
  const BitFolder c;
  ASSERT_EQ(c.laboratory().exit_code, 0);
  std::filesystem::create_directories(c.path("out"));
  c.write("out/mine.txt", "mine\n");
  std::filesystem::remove_all(c.path("cuts"));
  expect_refusal(c.calibrate(),
                 "output folder " + c.path("out").string() + ": exists; --force overwrites");
  EXPECT_FALSE(std::filesystem::exists(c.path("cuts")));
  EXPECT_EQ(files_below(c.path("out")), std::vector<std::string>{"mine.txt"});
  ASSERT_EQ(c.calibrate({"--force"}).exit_code, 0);
  EXPECT_EQ(read(c.path("out/mine.txt")), "mine\n");
  EXPECT_TRUE(std::filesystem::exists(c.path("out/calibration.json")));
}

TEST(BadCalibration, a_laboratory_does_not_overwrite_records) {
  const BitFolder c;
  c.write("lab.csv", "mine\n");
  expect_refusal(c.laboratory(), c.path("lab.csv").string() + ": exists; --force overwrites");
  EXPECT_EQ(read(c.path("lab.csv")), "mine\n");
}

}  // namespace
}  // namespace tdbd::app::bad_calibration_test
