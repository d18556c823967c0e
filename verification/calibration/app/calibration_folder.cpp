#include "calibration/app/calibration_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "calibration/cuts/cut_run.hpp"
#include "calibration/fit/problem.hpp"
#include "core/random.hpp"
#include "core/types.hpp"
#include "forces/rock/rock_material.hpp"

namespace tdbd::app {
namespace {

constexpr const char* cutter_case_text = R"([calibration]
law = "hanson-hansen"
records = "records.csv"
fit_bits = ["c13", "c19"]
predict_bits = ["c16"]
[cutters.c13]
diameter = "13 mm"
back_rake = "10 deg"
chamfer = "0.2 mm"
[cutters.c16]
diameter = "16 mm"
back_rake = "15 deg"
chamfer = "0.3 mm"
[cutters.c19]
diameter = "19 mm"
back_rake = "25 deg"
chamfer = "0.5 mm"
[rock]
material = "mancos-shale"
[noise]
reading = 0.03
[unknowns.A1]
start = 1.0
[unknowns.A3]
start = "18 deg"
range = ["0 deg", "45 deg"]
[unknowns.A5]
start = 1.0
[unknowns.A6]
start = 0.5
[unknowns.pressure_share]
start = 1.0
[fixed]
A4 = 0.5
[intervals]
bootstrap = 20
)";

forces::HansonHansen truth() {
  forces::HansonHansen law;
  law.A1 = 1.4;
  law.A3 = 22 * degree;
  law.A4 = 0.5;
  law.A5 = 1.2;
  law.A6 = 0.4;
  law.pressure_share = 0.8;
  return law;
}

constexpr double psi = 6894.757293168361;

std::string row(const std::string& name, const calibration::SingleCutter& cutter, double pressure,
                double depth, Random& random) {
  calibration::Record r;
  r.speed = 0.5;
  r.depth = depth;
  const forces::Strength rock =
      forces::strength_of(forces::rock_named("mancos-shale"), {.pressure = pressure}, {});
  const calibration::Loads loads =
      mean_loads(truth(), sample_of(calibration::groove_cut(cutter, depth), r, rock, truth()));
  return fmt::format("{}-{:.0f},{},{:.0f},500,{:.1f},{:.2f},{:.2f}\n", name, pressure / psi, name,
                     pressure / psi, 1e3 * depth, loads[0] * std::exp(random.uniform(-0.05, 0.05)),
                     loads[1] * std::exp(random.uniform(-0.05, 0.05)));
}

std::string cutter_records() {
  Random random{3};
  std::string text = "test,cutter,pressure [psi],speed [mm/s],depth [mm],normal [N],drag [N]\n";
  const std::pair<const char*, calibration::SingleCutter> cutters[] = {
      {"c13", {13e-3, 10 * degree, 0.0, 0.2e-3}},
      {"c16", {16e-3, 15 * degree, 0.0, 0.3e-3}},
      {"c19", {19e-3, 25 * degree, 0.0, 0.5e-3}}};
  for (const auto& [name, cutter] : cutters)
    for (const double pressure : {3000 * psi, 6000 * psi})
      for (const double depth : {0.5e-3, 1e-3, 2e-3})
        text += row(name, cutter, pressure, depth, random);
  return text;
}

constexpr const char* bit_text = R"(name = "small"
table = "{}.csv"
gage_diameter = "100 mm"
[cutters]
chamfer = "0.3 mm"
chamfer_angle = "45 deg"
[mesh]
rim_segments = 24
)";

/// The back rake of every cutter is RAKE.
constexpr const char* bit_table =
    R"(bit,cutter,blade,zone,dia_mm,r_tip_mm,phi_deg,h_tip_mm,profile_angle_deg,back_rake_deg,side_rake_deg
S,1,1,cone,16,5,0,6,-15,RAKE,0
S,2,2,cone,16,15,180,3.3,-15,RAKE,0
S,3,1,nose,16,25,10,1,0,RAKE,0
S,4,2,nose,16,34,190,1.5,15,RAKE,0
S,5,1,shoulder,16,42,20,5,45,RAKE,0
S,6,2,shoulder,16,47,200,11,70,RAKE,0
)";

std::string table_with(const std::string& rake) {
  std::string text = bit_table;
  for (std::size_t at = 0; (at = text.find("RAKE")) != std::string::npos;)
    text.replace(at, 4, rake);
  return text;
}

/// What the laboratory and the calibration have in common.
constexpr const char* small_bits_text = R"([bits]
S = "s.toml"
T = "t.toml"
[rock]
material = "mancos-shale"
edge_length = "4 mm"
[time]
revolutions = 2
steps_per_revolution = 40
[noise]
reading = 0.03
)";

constexpr const char* laboratory_text = R"([laboratory]
law = "hanson-hansen"
pressures = ["3000 psi", "6000 psi"]
rates = ["10 m/h", "20 m/h"]
rotary_speed = "120 rpm"
[truth]
A1 = 1.3
A3 = "22 deg"
A5 = 1.4
A6 = 0.4
)";

constexpr const char* bit_calibration_text = R"([calibration]
law = "hanson-hansen"
records = "lab.csv"
fit_bits = ["S"]
predict_bits = ["T"]
[unknowns.A1]
start = 1.0
[unknowns.A3]
start = "18 deg"
[unknowns.pressure_share]
start = 0.8
[fixed]
A5 = 1.4
A6 = 0.4
[intervals]
bootstrap = 10
)";

}  // namespace

CalibrationFolder::CalibrationFolder() {
  write("case.toml", cutter_case_text);
  write("records.csv", cutter_records());
}

battery::Outcome CalibrationFolder::calibrate(std::vector<std::string> more,
                                              const std::string& out) const {
  more.insert(more.begin(), {"calibrate", path("case.toml"), "-o", path(out)});
  return battery::run_tdbd(more);
}

BitFolder::BitFolder() {
  write("case.toml", std::string(bit_calibration_text) + small_bits_text);
  write("laboratory.toml", std::string(laboratory_text) + small_bits_text);
  write("s.toml", fmt::format(bit_text, "s"));
  write("t.toml", fmt::format(bit_text, "t"));
  write("s.csv", table_with("15"));
  write("t.csv", table_with("20"));
}

battery::Outcome BitFolder::laboratory(std::vector<std::string> more,
                                       const std::string& out) const {
  more.insert(more.begin(), {"laboratory", path("laboratory.toml"), "-o", path(out)});
  return battery::run_tdbd(more);
}

}  // namespace tdbd::app
