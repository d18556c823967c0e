#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "simulation/study/levels.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::simulation::state_variables_test {

std::string rotation_by(double angle) {
  const std::string c = std::to_string(std::cos(angle)), s = std::to_string(std::sin(angle));
  return "[[" + c + ",-" + s + ",0],[" + s + "," + c + ",0],[0,0,1]]";
}

std::string rotate_summary(double angle) {
  return R"({"command": "rotate", "duration_s": 2.5, "body_momentum": [3, 0, 4],
    "space_momentum": [0, 0, 0], "angular_velocity": [1, 2, 2], "cone_angles": [0.25],
    "cone_momenta": [7], "energy_end": 0.5, "energy_scale": 8, "attitude": )" +
         rotation_by(angle) + "}";
}

const StateVariable& variable(const EndState& end, const std::string& name) {
  for (const StateVariable& v : end.variables)
    if (v.name == name) return v;
  throw std::runtime_error("no " + name);
}

TEST(StateVariables, attitudes_differ_by_their_angle) {
  const EndState a = read_end_state(rotate_summary(0.0), "a");
  const EndState b = read_end_state(rotate_summary(0.01), "b");
  // Frobenius over sqrt(2) is 2 sin(angle/2); to_string keeps six digits
  EXPECT_NEAR(distance(variable(a, "attitude"), variable(b, "attitude")), 2.0 * std::sin(0.005),
              4.9e-7);
  EXPECT_EQ(distance(variable(a, "body_momentum"), variable(b, "body_momentum")), 0.0);
}

TEST(StateVariables, have_units_and_scales) {
  const EndState end = read_end_state(rotate_summary(0.3), "a");
  EXPECT_EQ(end.command, "rotate");
  EXPECT_EQ(end.duration, 2.5);
  EXPECT_EQ(end.variables.size(), 7u);
  EXPECT_EQ(variable(end, "body_momentum").scale, 5.0);
  EXPECT_EQ(variable(end, "space_momentum").scale, 0.0);
  EXPECT_EQ(variable(end, "cone_angles").scale, 1.0);
  EXPECT_EQ(variable(end, "energy").scale, 8.0);
  EXPECT_EQ(variable(end, "energy").units, "J");
  EXPECT_EQ(variable(end, "angular_velocity").units, "rad/s");
}

TEST(StateVariables, of_a_run_are_volumes) {
  const EndState end = read_end_state(
      R"({"command": "run", "duration_s": 1, "removed_volume_m3": 3,
          "removed_volume_by_part_m3": {"b": 1, "a/x": 2, "a/y": 4}, "removed_volume_by_revolution_m3": [3]})",
      "a");
  EXPECT_EQ(variable(end, "removed_volume_by_cutter").values, (std::vector<double>{6.0, 1.0}));
  EXPECT_EQ(variable(end, "removed_volume").values, std::vector<double>{3.0});
  EXPECT_EQ(variable(end, "removed_volume_by_part").values, (std::vector<double>{1.0, 2.0, 4.0}));
}

const char* forced_run = R"({"command": "run", "duration_s": 1, "removed_volume_m3": 3,
    "removed_volume_by_part_m3": {"b": 1, "a": 2}, "removed_volume_by_revolution_m3": [3],
    "wob_mean_n": 7, "tob_mean_n_m": 8, "rop_mean_m_per_s": null,
    "rotary_speed_mean_rad_per_s": 5, "drilling_power_mean_w": 6,
    "forces": [{"name": "a", "normal_mean_n": 4, "power_mean_w": 1}]})";

TEST(StateVariables, of_a_run_with_forces_are_means_too) {
  const EndState end = read_end_state(forced_run, "a");
  EXPECT_EQ(variable(end, "wob_mean").values, std::vector<double>{7.0});
  EXPECT_EQ(variable(end, "tob_mean").units, "N m");
  EXPECT_EQ(variable(end, "drilling_power_mean").values, std::vector<double>{6.0});
  EXPECT_THROW(variable(end, "rop_mean"), std::runtime_error);  // not known
  // by the bit's parts; part b had no force
  EXPECT_EQ(variable(end, "normal_mean_by_part").values, (std::vector<double>{0.0, 4.0}));
}

TEST(StateVariables, of_a_run_that_turned_farther_have_more_revolutions) {
  StateVariable a{"removed_volume_by_revolution", "m3", {3.0, 4.0}}, b = a;
  a.grows = b.grows = true;
  b.values.push_back(0.5);
  EXPECT_EQ(distance(a, b), 0.5);
  EXPECT_EQ(distance(b, a), 0.5);
}

TEST(StateVariables, of_a_bit_that_forces_move_are_its_place_and_momenta) {
  dynamics::DrillingState state;
  state.c_W = {1.0, 2.0, 3.0};
  state.rock_z = 0.5;
  state.momentum_W = {0.0, 3.0, 4.0};
  state.rotation.momentum_W = {0.0, 0.0, 2.0};
  state.rotation.cone_angles = {0.1};
  state.rotation.cone_momenta = {0.2};
  EndState end;
  add_motion(state, end);
  EXPECT_EQ(variable(end, "position").values, (std::vector<double>{1.0, 2.0, 2.5}));
  EXPECT_EQ(variable(end, "momentum").scale, 5.0);
  EXPECT_EQ(variable(end, "space_momentum").values, (std::vector<double>{0.0, 0.0, 2.0}));
  EXPECT_EQ(variable(end, "cone_angles").scale, 1.0);
  EXPECT_EQ(variable(end, "cone_momenta").values, std::vector<double>{0.2});
  EndState turned;
  state.rotation.q_WB = Eigen::Quaterniond(std::cos(0.005), 0.0, 0.0, std::sin(0.005));
  add_motion(state, turned);
  EXPECT_NEAR(distance(variable(end, "attitude"), variable(turned, "attitude")),
              2.0 * std::sin(0.005), 1e-15);
}

TEST(StateVariables, without_cones_have_none_of_theirs) {
  std::string text = rotate_summary(0.3);
  text.replace(text.find("[0.25]"), 6, "[]").replace(text.find("[7]"), 3, "[]");
  EXPECT_EQ(read_end_state(text, "a").variables.size(), 5u);
}

TEST(StateVariables, other_texts_are_rejected_by_name) {
  for (const char* text : {"", "no json", "{}", R"({"command": "bit", "duration_s": 1})",
                           R"({"command": "rotate", "duration_s": 1})"}) {
    try {
      read_end_state(text, "there.json");
      FAIL() << text;
    } catch (const InputError& e) {
      EXPECT_EQ(std::string(e.what()).rfind("there.json: found ", 0), 0u) << e.what();
    }
  }
}

TEST(StateVariables, are_found_in_a_folder_or_a_file) {
  const std::filesystem::path folder = tdbd::temporary_folder() + "tdbd_state_variables";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "summary.json") << rotate_summary(0.1);
  EXPECT_EQ(read_end_state_file(folder).duration, 2.5);
  EXPECT_EQ(read_end_state_file(folder / "summary.json").duration, 2.5);
  EXPECT_THROW(read_end_state_file(folder / "absent.json"), InputError);
}

}  // namespace tdbd::simulation::state_variables_test
