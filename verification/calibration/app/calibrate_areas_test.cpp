#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/mistake.hpp"
#include "calibration/app/calibration_folder.hpp"

/// Coefficients of one area of the bits ([areas.NAME] of a calibration and of a laboratory).
namespace tdbd::app::calibrate_areas_test {
namespace {

using nlohmann::json;

constexpr double hard_A1 = 2.1;

/// A laboratory in which the shoulder cutters are of another grade, and a calibration.
class AreaFolder : public BitFolder {
 public:
  explicit AreaFolder(const std::string& areas) {
    write("laboratory.toml",
          read(path("laboratory.toml")) +
              fmt::format("[areas.hard]\nzone = \"shoulder\"\n[areas.hard.truth]\nA1 = {}\n",
                          hard_A1));
    edit("laboratory.toml", "\"10 m/h\", \"20 m/h\"",
         "\"5 m/h\", \"10 m/h\", \"15 m/h\", \"20 m/h\"");
    edit("case.toml", "[fixed]\n", "[fixed]\n" + fixed_);
    write("case.toml", read(path("case.toml")) + areas);
  }

  /// In place of unknowns that the case has.
  void fix(const std::string& unknown, const std::string& value) {
    const std::string text = read(path("case.toml"));
    const auto from = text.find("[unknowns." + unknown + "]");
    const auto end = text.find('[', text.find('\n', from));
    write("case.toml", text.substr(0, from) + text.substr(end));
    edit("case.toml", "[fixed]\n", fmt::format("[fixed]\n{} = {}\n", unknown, value));
  }

  json result() const {
    const auto lab = laboratory();
    EXPECT_EQ(lab.exit_code, 0) << lab.err;
    const auto o = calibrate({"--force"});
    EXPECT_EQ(o.exit_code, 0) << o.err;
    return json::parse(read(path("out/calibration.json")));
  }

 private:
  std::string fixed_;
};

const std::string hard =
    "[areas.hard]\nzone = \"shoulder\"\n[areas.hard.unknowns.A1]\nstart = 1.0\n";

void expect_inside(const json& coefficients, const std::string& key, double truth) {
  const json& c = coefficients[key];
  fmt::print("{}: {:.4f} in [{:.4f}, {:.4f}], truth {}\n", key, c["value"].get<double>(),
             c["low"].get<double>(), c["high"].get<double>(), truth);
  EXPECT_LE(c["low"], truth) << key;
  EXPECT_GE(c["high"], truth) << key;
  EXPECT_LT(c["high"].get<double>() - c["low"].get<double>(), 0.5 * truth) << key;
}

TEST(CalibrateAreas, find_the_coefficient_of_an_area_with_the_others_fixed) {
  AreaFolder c(hard);
  c.fix("A1", "1.3");
  c.fix("A3", "\"22 deg\"");
  c.fix("pressure_share", "1.0");
  const json found = c.result();
  EXPECT_EQ(found["coefficients"].size(), 1U);
  expect_inside(found["coefficients"], "areas.hard.A1", hard_A1);
}

TEST(CalibrateAreas, find_the_coefficients_of_an_area_and_of_the_rest_together) {
  AreaFolder c(hard);
  c.fix("A3", "\"22 deg\"");
  const json found = c.result();
  expect_inside(found["coefficients"], "areas.hard.A1", hard_A1);
  expect_inside(found["coefficients"], "A1", 1.3);
  EXPECT_TRUE(found["weakest_direction"].contains("areas.hard.A1"));
}

/// The readings of the laboratory have what the area is for: without it the fit is worse.
TEST(CalibrateAreas, explain_readings_that_one_set_of_coefficients_does_not) {
  const auto chi2 = [](const std::string& areas) {
    AreaFolder c(areas);
    c.fix("pressure_share", "1.0");
    c.fix("A3", "\"22 deg\"");
    return c.result()["chi2"].get<double>();
  };
  const double with = chi2(hard), without = chi2("");
  fmt::print("chi2 {:.2f} with the area, {:.2f} without\n", with, without);
  EXPECT_LT(with, 0.5 * without);
}

/// law.toml of a result is that of a case: with the area and its coefficient.
TEST(CalibrateAreas, are_in_the_law_that_a_case_reads) {
  AreaFolder c(hard + "[areas.hard.fixed]\nA6 = 0.45\n");
  c.result();
  const std::string law = read(c.path("out/law.toml"));
  EXPECT_NE(law.find("\n[forces.areas.hard-face]\nkind = \"face\"\nzone = \"shoulder\"\nA1 = "),
            std::string::npos)
      << law;
  EXPECT_NE(law.find("[forces.areas.hard-chamfer]\nkind = \"chamfer\"\nzone = \"shoulder\"\n"),
            std::string::npos)
      << law;
  c.write("case.toml",
          "[bit]\nfile = \"s.toml\"\n[rock]\nedge_length = \"4 mm\"\nwall = \"20 mm\"\nmaterial = "
          "\"mancos-shale\"\npressure = \"3000 psi\"\n[motion]\nrotary_speed = \"120 "
          "rpm\"\nrate_of_penetration = \"20 m/h\"\n[time]\nstep = \"10 ms\"\nduration = \"40 "
          "ms\"\n" +
              law);
  EXPECT_EQ(c.check().exit_code, 0) << c.check().err;
}

/// Where the area has every part, nothing is left on which the law's own coefficient acts.
TEST(CalibrateAreas, that_leave_a_coefficient_without_parts_are_rejected) {
  AreaFolder c("[areas.all]\nnames = \"*\"\n[areas.all.unknowns.A1]\nstart = 1.0\n");
  ASSERT_EQ(c.laboratory().exit_code, 0);
  const auto o = c.calibrate();
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find("unknowns.A1: found a coefficient that acts on no part of the fitted bits"),
            std::string::npos)
      << o.err;
}

class BadCalibrationAreas : public ::testing::TestWithParam<Mistake> {};

/// `from`: the areas, from line 28 of the case on; % is the case.
TEST_P(BadCalibrationAreas, are_rejected_with_their_place_and_reason) {
  AreaFolder c(GetParam().from);
  ASSERT_EQ(c.laboratory().exit_code, 0);
  const auto o = c.calibrate();
  EXPECT_EQ(o.exit_code, 2);
  std::string message = "%:" + std::string(GetParam().message);
  for (auto at = message.find('%'); at != std::string::npos; at = message.find('%'))
    message.replace(at, 1, c.path("case.toml").string());
  EXPECT_EQ(o.err, "tdbd: " + message + "\n");
}

const Mistake mistakes[] = {
    {"an_area_that_no_bit_has", "[areas.a]\nzone = \"gage\"\n[areas.a.unknowns.A1]\nstart = 1.0\n",
     "",
     "28: areas.a: found criteria that no face, chamfer or cse of a cutter meets, expected such a "
     "part of one of the bits: S, T"},
    {"an_area_without_criteria", "[areas.a]\n[areas.a.unknowns.A1]\nstart = 1.0\n", "",
     "28: areas.a: found no parts selected, expected at least one of kind, zone, blade, cone, row, "
     "names and part"},
    {"an_area_without_a_coefficient", "[areas.a]\nzone = \"nose\"\n", "",
     "28: areas.a: found no coefficient, expected coefficients of the law in its tables unknowns "
     "or fixed"},
    {"a_coefficient_that_the_law_lacks",
     "[areas.a]\nzone = \"nose\"\n[areas.a.unknowns.A66]\nstart = 1.0\n", "",
     "30: areas.a.unknowns.A66: found no coefficient of hanson-hansen, expected A6?"},
    {"a_fixed_coefficient_that_the_law_lacks",
     "[areas.a]\nzone = \"nose\"\n[areas.a.fixed]\nB1 = 1.0\n", "",
     "31: areas.a.fixed.B1: found no coefficient of hanson-hansen, expected A1?"},
    {"a_coefficient_fitted_and_fixed",
     "[areas.a]\nzone = \"nose\"\n[areas.a.unknowns.A1]\nstart = 1.0\n[areas.a.fixed]\nA1 = 1.0\n",
     "",
     "33: areas.a.fixed.A1: found a value for what is fitted, expected it here or in unknowns, not "
     "in both"},
    {"two_areas_that_disagree",
     "[areas.a]\nblade = 1\n[areas.a.fixed]\nA1 = 1.0\n[areas.b]\nblade = 1\n[areas.b.fixed]\nA1 = "
     "2.0\n",
     "",
     "32: areas.b.A1: found 2 for cutter-1/face, expected 1, as %:28: areas.a gives with the "
     "same criteria, or a more particular area that decides"},
    {"an_unknown_table", "[areas.a]\nzone = \"nose\"\n[areas.a.unknown.A1]\nstart = 1.0\n", "",
     "28: areas.a: found no coefficient, expected coefficients of the law in its tables unknowns "
     "or "
     "fixed"},
};

INSTANTIATE_TEST_SUITE_P(One, BadCalibrationAreas, ::testing::ValuesIn(mistakes),
                         [](const auto& m) { return std::string(m.param.name); });

}  // namespace
}  // namespace tdbd::app::calibrate_areas_test
