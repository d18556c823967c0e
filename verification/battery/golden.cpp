#include "verification/battery/golden.hpp"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.hpp"

namespace tdbd::battery {
namespace {

using nlohmann::json;

json read(const std::string& name) {
  const std::string path = std::string(TDBD_GOLDEN_FOLDER) + "/" + name + ".json";
  std::ifstream file(path);
  if (!file) throw InputError(path + ": no such file");
  return json::parse(file);
}

Vec3 vector3(const json& j) {
  return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()};
}

Mat3 matrix3(const json& rows) {
  Mat3 A;
  for (int i = 0; i < 3; ++i) A.row(i) = vector3(rows.at(static_cast<std::size_t>(i)));
  return A;
}

std::vector<double> numbers(const json& j) { return j.get<std::vector<double>>(); }

/// What states and steps share.
GoldenState common_state(const json& j, double time) {
  GoldenState s;
  s.time = time;
  s.R_WB = matrix3(j.at("R"));
  s.body_momentum_B = vector3(j.at("P"));
  s.cone_angles = numbers(j.at("phi"));
  s.cone_momenta = numbers(j.at("p"));
  return s;
}

GoldenState full_state(const json& j) {
  GoldenState s = common_state(j, j.at("t").get<double>());
  s.w_B = vector3(j.at("W"));
  s.momentum_W = vector3(j.at("pi_spatial"));
  s.energy = j.at("energy").get<double>();
  return s;
}

dynamics::Gyrostat gyrostat(const json& j) {
  std::vector<dynamics::Cone> cones;
  for (std::size_t k = 0; k < j.at("s").size(); ++k)
    cones.push_back({vector3(j.at("s")[k]), j.at("Ic").at(k).get<double>()});
  return dynamics::make_gyrostat(matrix3(j.at("I_locked")), cones, dynamics::InertiaCheck::off);
}

dynamics::Loads loads(const json& j) {
  dynamics::Loads l;
  l.body_torque_B = vector3(j.at("tb"));
  l.gravity_moment = j.at("mgl").get<double>();
  l.gravity_arm_B = vector3(j.at("e")).normalized();
  for (const double torque : numbers(j.at("tc"))) {
    l.cones.emplace_back();
    l.cones.back().internal = torque;
  }
  return l;
}

/// The first state, in the program's unknowns.
dynamics::RotationState initial(const GoldenState& s) {
  dynamics::RotationState r;
  r.q_WB = Eigen::Quaterniond(s.R_WB).normalized();
  r.momentum_W = s.momentum_W;
  r.cone_angles = s.cone_angles;
  r.cone_momenta = s.cone_momenta;
  return r;
}

/// "LieMid x2 (a note)" -> "LieMid", 2.
GoldenStep step(const json& j) {
  const auto method = j.at("method").get<std::string>();
  const std::size_t x = method.find(" x");
  GoldenStep s;
  s.drift = method.substr(0, x);
  s.drifts_per_step = std::stoi(method.substr(x + 2));
  s.h = j.at("h").get<double>();
  s.after_1 = common_state(j.at("after_1"), s.h);
  s.after_100 = common_state(j.at("after_100"), 100.0 * s.h);
  return s;
}

}  // namespace

std::vector<std::string> golden_names() {
  return {"slow_top",       "fast_top",      "free_asym_111",       "free_asym_unstable",
          "body_torque_3",  "gyro_free_sym", "gyro_free_asym_phys", "heavy_gyro",
          "heavy_gyro_phys"};
}

GoldenCase read_golden_case(const std::string& name) {
  const json j = read(name);
  GoldenCase c;
  c.name = name;
  c.gyrostat = gyrostat(j);
  c.loads = loads(j);
  for (const json& state : j.at("states")) c.states.push_back(full_state(state));
  c.initial = initial(c.states.front());
  return c;
}

std::vector<GoldenStep> read_golden_steps(const std::string& name) {
  const json all = read("steps_" + name);
  std::vector<GoldenStep> steps;
  for (const json& s : all.at("steps")) steps.push_back(step(s));
  return steps;
}

}  // namespace tdbd::battery
