#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/rotate_folder.hpp"
#include "battery/golden.hpp"

namespace tdbd::app::rotate_golden_test {

using Json = nlohmann::json;

/// The composition of order 6 at 0.01 s against 16 golden digits; scale: the variable's largest
/// value, or 1. What is left is rounding, a few hundred steps of it.
constexpr double order_6_agrees = 1e-11;

/// The plain step of order 2 at 1 ms over one second; same scale. Its error is about h^2.
constexpr double order_2_agrees = 2e-5;

Json golden(const std::string& name) {
  return Json::parse(
      read(std::string(TDBD_SOURCE_DIR "/verification/data/golden/") + name + ".json"));
}

/// The inputs of a golden case as a case file.
std::string case_of(const Json& g) {
  std::string text = "[body]\ncheck = \"off\"\ninertia = " + g["I_locked"].dump() +
                     "\nrotation_vector = " + g["rv0"].dump() +
                     "\nangular_velocity = " + g["W0"].dump() + "\n";
  for (std::size_t k = 0; k < g["s"].size(); ++k)
    text += "[[cones]]\naxis = " + g["s"][k].dump() + "\naxial_inertia = " + g["Ic"][k].dump() +
            "\nspin = " + g["phidot0"][k].dump() + "\ntorque = " + g["tc"][k].dump() + "\n";
  return text + "[load]\nbody_torque = " + g["tb"].dump() +
         "\ngravity_moment = " + g["mgl"].dump() + "\ngravity_arm = " + g["e"].dump() +
         "\n[time]\nstep = 0.01\nduration = 1\n";
}

/// The golden state at this time.
Json state_at(const Json& g, double time) {
  for (const Json& s : g["states"])
    if (s["t"].get<double>() == time) return s;
  throw std::runtime_error("no golden state at this time");
}

std::vector<double> flat(const Json& j) {
  std::vector<double> values;
  for (const Json& v : j.is_array() ? j.flatten() : Json::array({j}))
    if (v.is_number()) values.push_back(v.get<double>());
  return values;
}

void expect_near(const Json& found, const Json& expected, double tolerance,
                 const std::string& what) {
  const std::vector<double> a = flat(found), b = flat(expected);
  ASSERT_EQ(a.size(), b.size()) << what;
  double scale = 1.0;
  for (const double x : b) scale = std::max(scale, std::abs(x));
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a[i], b[i], tolerance * scale) << what << " " << i;
}

void expect_state(const Json& summary, const Json& state, double tolerance,
                  const std::string& name) {
  expect_near(summary["attitude"], state["R"], tolerance, name + " attitude");
  expect_near(summary["body_momentum"], state["P"], tolerance, name + " body momentum");
  expect_near(summary["space_momentum"], state["pi_spatial"], tolerance, name + " momentum");
  expect_near(summary["angular_velocity"], state["W"], tolerance, name + " angular velocity");
  expect_near(summary["cone_angles"], state["phi"], tolerance, name + " cone angles");
  expect_near(summary["cone_momenta"], state["p"], tolerance, name + " cone momenta");
  expect_near(summary["energy_end"], state["energy"], tolerance, name + " energy");
}

Json summary_of(const RotateFolder& c, std::vector<std::string> more) {
  more.insert(more.end(), {"--quiet", "--force"});
  const auto o = c.rotate(more);
  EXPECT_EQ(o.exit_code, 0) << o.err;
  return Json::parse(read(c.path("out/summary.json")));
}

TEST(RotateGolden, order_6_agrees_with_every_golden_case) {
  const RotateFolder c;
  for (const std::string& name : battery::golden_names()) {
    const Json g = golden(name);
    c.write("case.toml", case_of(g));
    for (const char* duration : {"1", "2"})
      expect_state(summary_of(c, {"--set", "integrator.order=6", "--set",
                                  std::string("time.duration=") + duration}),
                   state_at(g, std::stod(duration)), order_6_agrees, name + " at " + duration);
  }
}

TEST(RotateGolden, order_2_agrees_to_the_square_of_the_step) {
  const RotateFolder c;
  for (const std::string name : {"slow_top", "heavy_gyro_phys", "body_torque_3"}) {
    const Json g = golden(name);
    c.write("case.toml", case_of(g));
    for (const char* drift : {"split", "three-axis", "lie-midpoint", "lie-mean"})
      expect_state(summary_of(c, {"--set", std::string("integrator.drift=") + drift, "--set",
                                  "time.step=0.001"}),
                   state_at(g, 1.0), order_2_agrees, name + " with " + drift);
  }
}

TEST(RotateGolden, the_start_is_the_golden_one) {
  const RotateFolder c;
  for (const std::string& name : battery::golden_names()) {
    const Json g = golden(name);
    c.write("case.toml", case_of(g));
    const Json s = summary_of(c, {});
    expect_near(s["energy_start"], g["states"][0]["energy"], 1e-15, name);
    expect_near(s["space_momentum_start"], g["states"][0]["pi_spatial"], 1e-15, name);
  }
}

/// The shipped cases are the golden ones where they say so.
TEST(RotateGolden, the_slow_top_and_similar_cases_are_shipped) {
  const std::pair<const char*, const char*> shipped[] = {{"slow-top", "slow_top"},
                                                         {"heavy-gyrostat", "heavy_gyro_phys"},
                                                         {"free-rotation", "gyro_free_asym_phys"}};
  const RotateFolder c;
  for (const auto& [file, name] : shipped) {
    c.write("case.toml", read(TDBD_SOURCE_DIR "/cases/" + std::string(file) + ".toml"));
    expect_state(summary_of(c, {"--set", "integrator.order=6", "--set", "time.duration=2"}),
                 state_at(golden(name), 2.0), order_6_agrees, file);
  }
}

}  // namespace tdbd::app::rotate_golden_test
