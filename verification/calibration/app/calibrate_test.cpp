#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "calibration/app/calibration_folder.hpp"

namespace tdbd::app::calibrate_test {
namespace {

using nlohmann::json;

json calibration_of(const CaseFolder& c, const std::string& out = "out") {
  return json::parse(read(c.path(out) / "calibration.json"));
}

TEST(Calibrate, leaves_its_files_and_finds_the_truth_within_its_intervals) {
  const CalibrationFolder c;
  const auto o = c.calibrate();
  ASSERT_EQ(o.exit_code, 0) << o.err;
  EXPECT_EQ(files_below(c.path("out")),
            (std::vector<std::string>{"calibration.json", "case.toml", "law.toml",
                                      "predictions.csv", "residuals.csv", "timing.json"}));
  const json found = calibration_of(c);
  const json& k = found["coefficients"];
  EXPECT_LT(k["A1"]["low"], 1.4);
  EXPECT_GT(k["A1"]["high"], 1.4);
  EXPECT_EQ(k["A1"]["unit"], "1");
  EXPECT_LT(k["A3"]["low"], 0.384);
  EXPECT_GT(k["A3"]["high"], 0.384);
  EXPECT_GT(k["A6"]["bootstrap"]["se"], 0.0);
  EXPECT_EQ(found["degrees_of_freedom"], 24 - 5);
  EXPECT_LT(found["withheld_bit_error_normal_rms"], 0.1);
  EXPECT_EQ(found["singular_values"].size(), 5u);
  double squares = 0.0;  // of a direction of length 1
  for (const auto& share : found["weakest_direction"])
    squares += share.get<double>() * share.get<double>();
  EXPECT_NEAR(squares, 1.0, 1e-12);
  EXPECT_EQ(lines_of(c.path("out/predictions.csv")), 1 + 6);
  EXPECT_EQ(lines_of(c.path("out/residuals.csv")), 1 + 12);
  EXPECT_NE(o.out.find("weakest direction: "), std::string::npos);
}

TEST(Calibrate, warns_of_an_unknown_error_of_the_law) {
  const CalibrationFolder c;
  const std::string warning =
      "the error of the law is unknown, so intervals contain the noise only: ";
  const auto both = c.calibrate({"--force"}),
             one = c.calibrate({"--force", "--set", "calibration.fit_bits=[\"c13\"]"});
  EXPECT_EQ(both.err.find(warning), std::string::npos) << both.err;
  EXPECT_NE(one.err.find("tdbd: warning: " + warning), std::string::npos) << one.err;
}

/// The readings of a cutter in granite, and the same with a null value in the first row.
class GrooveFolder : public CalibrationFolder {
 public:
  explicit GrooveFolder(const std::string& depth = "0.013", const std::string& normal = "20.2") {
    write("case.toml",
          "[calibration]\nlaw = \"hanson-hansen\"\nrecords = \"records.csv\"\nfit_bits = [\"j\"]\n"
          "predict_bits = []\n[cutters.j]\ndiameter = \"0.5 in\"\nback_rake = \"20 deg\"\n"
          "[rock]\nmaterial = \"sierra-white-granite\"\n[noise]\nreading = 0.04\nrop = 0.02\n"
          "[unknowns.A1]\nstart = 1.0\n[unknowns.A3]\nstart = \"20 deg\"\n");
    std::string text = "test,cutter,speed [in/s],depth [in],normal [lbf],drag [lbf]\n";
    text += "a,j,2.1," + depth + "," + normal + ",16.9\n";
    for (const char* row : {"0.015,25.3,16.8", "0.016,30.4,17", "0.017,31.7,26.3",
                            "0.018,29.2,18.8", "0.02,38,28.9", "0.037,136,118", "0.039,131,118",
                            "0.039,136,120", "0.039,137,121", "0.061,229,217", "0.062,256,227"})
      text += std::string("a,j,2.1,") + row + "\n";
    write("records.csv", text);
  }
  double fitted(const std::string& key, const std::string& out) const {
    return calibration_of(*this, out)["coefficients"][key]["value"];
  }
};

/// The area of a groove is that of the whole face for all larger depths.
TEST(Calibrate, rejects_a_groove_deeper_than_the_face) {
  for (const auto& [depth, mm] : {std::pair("0.6", "15.24"), {"0.5", "12.7"}, {"0.47", "11.94"}}) {
    const GrooveFolder c(depth);
    expect_refusal(c.calibrate(),
                   c.path("records.csv").string() + ":2: depth: found " + mm +
                       " mm, expected at most 11.93 mm, the height of the face of 'j' (diameter "
                       "12.7 mm, back rake 20 deg)");
    EXPECT_FALSE(std::filesystem::exists(c.path("out")));
  }
  EXPECT_EQ(GrooveFolder("0.4697").calibrate().exit_code, 0);
}

TEST(Calibrate, rejects_a_bit_that_advances_by_more_than_its_cutters) {
  const BitFolder c;
  c.write("deep.csv",
          "test,bit,pressure [psi],rotary_speed [rpm],rate_of_penetration [m/s],wob [kN]\n"
          "1,S,3000,120,15,42.5\n");
  const auto o =
      c.calibrate({"--set", "calibration.records=" + c.path("deep.csv").string(), "--set",
                   "calibration.fit_bits=[\"S\"]", "--set", "calibration.predict_bits=[]"});
  EXPECT_EQ(o.exit_code, 2) << o.err;
  EXPECT_NE(o.err.find("deep.csv:2: rate_of_penetration: found "), std::string::npos) << o.err;
}

/// One null value (999.25) moves A3 by half. With the robust loss, its effect is small.
TEST(Calibrate, names_the_row_that_fits_worst_and_has_a_robust_loss) {
  const std::vector<std::string> huber{"--set", "calibration.loss=huber"};
  std::map<std::string, double> right;
  {
    const GrooveFolder good;
    ASSERT_EQ(good.calibrate(huber, "robust").exit_code, 0);
    for (const char* key : {"A1", "A3"}) right[key] = good.fitted(key, "robust");
  }
  const GrooveFolder wrong("0.013", "999.25");
  const auto o = wrong.calibrate({"--force"}), robust = wrong.calibrate(huber, "wrong-robust");
  EXPECT_NE(o.err.find("; the normal of " + wrong.path("records.csv").string() +
                       ":2 fits worst, 79 standard deviations away"),
            std::string::npos)
      << o.err;
  EXPECT_NE(o.err.find("records.csv:2: normal: 999.25 usually means \"no value\""),
            std::string::npos)
      << o.err;
  ASSERT_EQ(robust.exit_code, 0) << robust.err;
  EXPECT_GT(std::abs(wrong.fitted("A3", "out") / right["A3"] - 1.0), 0.2);
  for (const auto& [key, value] : right) {
    EXPECT_LT(std::abs(wrong.fitted(key, "wrong-robust") / value - 1.0), 0.1) << key;  // 0.067
  }
}

TEST(Calibrate, names_the_starts_from_which_no_fit_converges) {
  const GrooveFolder c;
  const auto o = c.calibrate({"--set", "unknowns.A1.start=1e6"});
  EXPECT_EQ(o.exit_code, 1) << o.out;
  EXPECT_EQ(o.err.find("success"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("A1.start = 1e+06"), std::string::npos) << o.err;
}

TEST(Laboratory, makes_the_folder_of_its_records) {
  const BitFolder c;
  const auto o = c.laboratory({"--cuts", c.path("lab-cuts")}, "new/folder/lab.csv");
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_GT(lines_of(c.path("new/folder/lab.csv")), 4);
}

TEST(Calibrate, leaves_the_same_bytes_again_and_with_more_threads) {
  const BitFolder c;
  ASSERT_EQ(c.laboratory({"--cuts", c.path("lab-cuts")}).exit_code, 0);
  ASSERT_EQ(c.calibrate({"--quiet"}, "first").exit_code, 0);
  ASSERT_EQ(c.calibrate({"--quiet"}, "second").exit_code, 0);
  expect_same_results(c.path("first"), c.path("second"), 10);
  ASSERT_EQ(
      c.calibrate({"--quiet", "--threads", "3", "--cuts", c.path("other-cuts")}, "third").exit_code,
      0);
  expect_same_results(c.path("first"), c.path("third"), 10);
  ASSERT_EQ(c.laboratory({"--threads", "2", "--cuts", c.path("cuts")}, "again.csv").exit_code, 0);
  EXPECT_EQ(read(c.path("lab.csv")), read(c.path("again.csv")));
}

/// All cut runs of a folder.
std::vector<std::filesystem::path> cut_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry);
  return files;
}

TEST(Calibrate, repeats_only_a_truncated_cut_run) {
  const BitFolder c;
  ASSERT_EQ(c.laboratory().exit_code, 0);
  ASSERT_EQ(c.calibrate({}, "before").exit_code, 0);
  EXPECT_EQ(json::parse(read(c.path("before/timing.json")))["cut_runs_made"], 0);
  const auto files = cut_files(c.path("cuts"));
  ASSERT_EQ(files.size(), 4u);
  const std::string whole = read(files[1]);
  std::filesystem::resize_file(files[1], whole.size() / 2);
  ASSERT_EQ(c.calibrate({}, "after").exit_code, 0);
  const json timing = json::parse(read(c.path("after/timing.json")));
  EXPECT_EQ(timing["cut_runs_made"], 1);
  EXPECT_EQ(timing["cut_runs_found"], 3);
  EXPECT_EQ(read(files[1]), whole);
  expect_same_results(c.path("before"), c.path("after"), 10);
}

TEST(Calibrate, another_pressure_speed_or_coefficient_makes_no_cut_run) {
  const BitFolder c;
  ASSERT_EQ(c.laboratory().exit_code, 0);
  c.edit("laboratory.toml", "120 rpm", "60 rpm");
  c.edit("laboratory.toml", "\"10 m/h\", \"20 m/h\"", "\"5 m/h\", \"10 m/h\"");
  c.edit("laboratory.toml", "A1 = 1.3", "A1 = 0.7");
  c.edit("laboratory.toml", "6000 psi", "9000 psi");
  ASSERT_EQ(c.laboratory({"--force"}).exit_code, 0);
  EXPECT_EQ(cut_files(c.path("cuts")).size(), 4u);
  c.edit("s.csv", "15,0", "16,0");
  ASSERT_EQ(c.laboratory({"--force"}).exit_code, 0);
  EXPECT_EQ(cut_files(c.path("cuts")).size(), 6u);
}

TEST(Calibrate, warns_of_a_coefficient_at_its_bound) {
  const CalibrationFolder c;
  c.edit("case.toml", "[\"0 deg\", \"45 deg\"]", "[\"0 deg\", \"19 deg\"]");
  const auto o = c.calibrate();
  EXPECT_EQ(o.exit_code, 0);
  const std::string warning = "tdbd: warning: " + c.path("case.toml").string() +
                              ":24: unknowns.A3: 0.3316 is an end of its range: no interval\n";
  EXPECT_EQ(o.err.rfind(warning, 0), 0U) << o.err;  // a warning of a misfit may follow
  const json A3 = calibration_of(c)["coefficients"]["A3"];
  EXPECT_TRUE(A3["at_bound"]);
  EXPECT_TRUE(A3["se"].is_null());
  EXPECT_TRUE(A3["low"].is_null());
  EXPECT_NE(o.out.find("at an end of its range"), std::string::npos);
}

TEST(Calibrate, fits_each_pressure_alone) {
  const CalibrationFolder c;
  c.edit("case.toml", "[cutters.c13]", "pressures = \"separate\"\n[cutters.c13]");
  c.edit("case.toml", "[unknowns.pressure_share]\nstart = 1.0\n", "");
  const auto o = c.calibrate();
  ASSERT_EQ(o.exit_code, 0) << o.err;
  EXPECT_TRUE(std::filesystem::exists(c.path("out/law-20.684MPa.toml")));
  EXPECT_TRUE(std::filesystem::exists(c.path("out/law-41.369MPa.toml")));
  const json found = calibration_of(c);
  ASSERT_EQ(found["by_pressure"].size(), 2u);
  double sum = 0.0;
  for (const json& set : found["by_pressure"]) sum += set["objective_normal"].get<double>();
  EXPECT_DOUBLE_EQ(found["objective_normal"], sum);
  long freedom = 0;
  for (const json& set : found["by_pressure"]) freedom += set["degrees_of_freedom"].get<long>();
  EXPECT_EQ(found["degrees_of_freedom"], freedom);
}

/// The resolved case stands elsewhere and gives the same numbers.
TEST(Calibrate, the_resolved_case_is_the_case) {
  const CalibrationFolder c;
  ASSERT_EQ(c.calibrate().exit_code, 0);
  const auto o =
      battery::run_tdbd({"calibrate", c.path("out/case.toml"), "-o", c.path("resolved")});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  expect_same_results(c.path("out"), c.path("resolved"), 6);
}

TEST(Calibrate, the_law_that_it_writes_runs) {
  const BitFolder c;
  ASSERT_EQ(c.laboratory().exit_code, 0);
  ASSERT_EQ(c.calibrate().exit_code, 0);
  c.write("case.toml",
          "[bit]\nfile = \"s.toml\"\n[rock]\nedge_length = \"4 mm\"\nwall = \"20 mm\"\nmaterial = "
          "\"mancos-shale\"\npressure = \"3000 psi\"\n[motion]\nrotary_speed = \"120 "
          "rpm\"\nrate_of_penetration = \"20 m/h\"\n[time]\nstep = \"10 ms\"\nduration = \"40 "
          "ms\"\n" +
              read(c.path("out/law.toml")));
  EXPECT_EQ(c.check().exit_code, 0) << c.check().err;
}

}  // namespace
}  // namespace tdbd::app::calibrate_test
