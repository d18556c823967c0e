#include "simulation/rotate/rotate_case.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <numbers>

#include "core/error.hpp"
#include "dynamics/momenta.hpp"
#include "mesh/files/files.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::simulation::rotate_case_test {

using namespace dynamics;

constexpr const char* all_keys = R"(title = "every key"
[body]
inertia = [[2, 0, 0], [0, 2.6, 0], [0, 0, 3]]
rotation_vector = [0, 0, "90 deg"]
angular_velocity = [0.5, -0.4, 2]
[[cones]]
axis = [0, 0, 5]
axial_inertia = "0.1 kg m2"
spin = -6
angle = 0.5
torque = 0.01
external_torque = 0.02
damping = 0.03
[load]
body_torque = [1, 2, 3]
space_torque = [4, 5, 6]
gravity_moment = -5
gravity_arm = [3, 0, 4]
stiffness = [7, 8, 9]
damping = [0.1, 0.2, 0.3]
[[load.harmonics]]
amplitude = [0, 0.3, 0]
angular_frequency = 2
phase = 0.4
[[load.harmonics]]
frame = "space"
amplitude = [1, 0, 0]
[[load.samples]]
frame = "space"
file = "rotate_case_torque.csv"
[integrator]
drift = "lie-mean"
drifts_per_step = 2
order = 4
[time]
step = 0.1
duration = 2
[output]
history_every = 3
)";

RotateCase read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const std::string path = tdbd::temporary_folder() + "rotate_case.toml";
  std::ofstream(tdbd::temporary_folder() + "rotate_case_torque.csv")
      << "time_s,x,y,z\n0.5,1,2,3\n1.5,4,5,6\n";
  std::ofstream(path) << text;
  return read_rotate_case(path, overrides);
}

TEST(RotateCase, reads_the_body_and_how_it_starts) {
  const RotateCase c = read(all_keys);
  EXPECT_EQ(c.title, "every key");
  EXPECT_EQ(c.body.inertia_B(1, 1), 2.6);
  ASSERT_EQ(c.body.cones.size(), 1u);
  EXPECT_EQ(c.body.cones[0].axis_B, Vec3::UnitZ());
  EXPECT_EQ(c.body.cones[0].axial_inertia, 0.1);
  const Mat3 quarter_turn = c.start.q_WB.toRotationMatrix();
  EXPECT_LT((quarter_turn * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_EQ(c.start.cone_angles, std::vector<double>{0.5});
  EXPECT_DOUBLE_EQ(c.start.cone_momenta[0], 0.1 * (-6.0 + 2.0));
  EXPECT_LT((angular_velocity(c.body, c.start) - Vec3(0.5, -0.4, 2.0)).norm(), 1e-14);
}

TEST(RotateCase, reads_the_loads) {
  const Loads l = read(all_keys).loads;
  EXPECT_EQ(l.body_torque_B, Vec3(1, 2, 3));
  EXPECT_EQ(l.space_torque_W, Vec3(4, 5, 6));
  EXPECT_EQ(l.gravity_moment, -5.0);
  EXPECT_LT((l.gravity_arm_B - Vec3(0.6, 0, 0.8)).norm(), 1e-15);
  EXPECT_EQ(l.stiffness_W, Vec3(7, 8, 9));
  EXPECT_EQ(l.damping_W, Vec3(0.1, 0.2, 0.3));
  ASSERT_EQ(l.cones.size(), 1u);
  EXPECT_EQ(l.cones[0].internal, 0.01);
  EXPECT_EQ(l.cones[0].external, 0.02);
  EXPECT_EQ(l.cones[0].damping, 0.03);
}

TEST(RotateCase, reads_torques_that_depend_on_time) {
  const Loads l = read(all_keys).loads;
  ASSERT_EQ(l.harmonics.size(), 2u);
  EXPECT_EQ(l.harmonics[0].frame, TorqueFrame::body);
  EXPECT_EQ(l.harmonics[0].amplitude, Vec3(0, 0.3, 0));
  EXPECT_EQ(l.harmonics[0].angular_frequency, 2.0);
  EXPECT_EQ(l.harmonics[0].phase, 0.4);
  EXPECT_EQ(l.harmonics[1].frame, TorqueFrame::space);
  ASSERT_EQ(l.samples.size(), 1u);
  EXPECT_EQ(l.samples[0].frame, TorqueFrame::space);
  EXPECT_EQ(l.samples[0].times, (std::vector<double>{0.5, 1.5}));
  EXPECT_EQ(l.samples[0].torques[1], Vec3(4, 5, 6));
}

TEST(RotateCase, reads_the_integrator) {
  const RotateCase c = read(all_keys);
  EXPECT_EQ(c.integrator.drift, Drift::lie_mean);
  EXPECT_EQ(c.integrator.drifts_per_step, 2);
  EXPECT_EQ(c.integrator.order, 4);
  EXPECT_EQ(c.history_every, 3);
  EXPECT_EQ(c.time.steps, 20);
  EXPECT_EQ(drift_name(c.integrator.drift), "lie-mean");
}

TEST(RotateCase, only_order_2_predicts_by_default) {
  for (const char* order : {"2", "4", "6", "8"}) {
    const RotateCase c = read(all_keys, {std::string("integrator.order=") + order});
    EXPECT_EQ(c.integrator.velocity_torque,
              std::string(order) == "2" ? VelocityTorque::predicted : VelocityTorque::symmetric);
  }
}

TEST(RotateCase, the_resolved_case_is_the_same_case) {
  const RotateCase first = read(all_keys);
  const RotateCase again = read(first.resolved);
  EXPECT_EQ(again.resolved, first.resolved);
  EXPECT_EQ(again.hash, first.hash);
  EXPECT_EQ(again.loads.harmonics[1].amplitude, Vec3(1, 0, 0));
  EXPECT_EQ(again.start.momentum_W, first.start.momentum_W);
}

TEST(RotateCase, lists_its_quantities) {
  const RotateCase c = read(all_keys);
  EXPECT_EQ(c.quantities.at("time.step"), 0.1);
  EXPECT_EQ(c.quantities.at("cones[0].axial_inertia"), 0.1);
  EXPECT_EQ(c.quantities.count("body.inertia"), 0u);
}

TEST(RotateCase, a_history_has_ten_thousand_rows_by_default) {
  const std::string text =
      "[body]\ninertia = [[1,0,0],[0,1,0],[0,0,1]]\n[time]\nstep = 1\nduration = ";
  const std::pair<const char*, long> expected[] = {
      {"1", 1}, {"10000", 1}, {"10001", 2}, {"1e7", 1000}};
  for (const auto& [duration, every] : expected)
    EXPECT_EQ(read(text + duration).history_every, every) << duration;
}

TEST(RotateCase, steps_fit_the_duration) {
  const std::string text =
      "[body]\ninertia = [[1,0,0],[0,1,0],[0,0,1]]\n[time]\nduration = 1\nstep = ";
  EXPECT_EQ(read(text + "0.1").time.step, 0.1);
  EXPECT_EQ(read(text + "0.3").time.steps, 4);
  EXPECT_EQ(read(text + "0.3").time.step, 0.25);
  EXPECT_EQ(read(text + "1").time.steps, 1);
  EXPECT_EQ(read(text + "0.6").time.steps, 2);
  EXPECT_EQ(read(text + "0.33333333333").time.steps, 3);  // whole to 1e-10 of a step
  EXPECT_EQ(read(text + "1e-7").time.steps, 10'000'000);
}

/// For a cube of 40 m the message suggests 40 mm, unless the case confirms the size.
TEST(RotateCase, requires_the_unit_of_a_mesh) {
  mesh::write_mesh(tdbd::temporary_folder() + "rotate_case_cube.ply",
                   battery::box({-20, -20, -20}, {20, 20, 20}));
  const auto refusal = [](const std::string& more) -> std::string {
    try {
      read("[body]\nmesh = \"rotate_case_cube.ply\"\ndensity = 7800\nunit = \"1 m\"\n" + more +
           "[time]\nstep = 0.1\nduration = 1\n");
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_NE(refusal("").find("body.unit: found a size of 40000 mm"), std::string::npos);
  EXPECT_EQ(refusal("unit_check = \"off\"\n"), "");
}

TEST(RotateCase, rejects_steps_that_are_longer_than_the_run_or_without_number) {
  const std::string text =
      "[body]\ninertia = [[1,0,0],[0,1,0],[0,0,1]]\n[time]\nduration = 1\nstep = ";
  const auto refusal = [&](const std::string& step) -> std::string {
    try {
      read(text + step);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_NE(refusal("1.1").find("time.step: found 1.1 s for a run of 1 s, expected at most the"),
            std::string::npos);
  EXPECT_NE(refusal("1e-16").find("time.step: found 1e-16 s, which makes 1e+16 steps, expected at"),
            std::string::npos);
}

TEST(RotateCase, is_distinguished_from_a_run) {
  const std::string path = tdbd::temporary_folder() + "rotate_or_run.toml";
  std::ofstream(path) << "[bit]\nfile = \"x\"\n";
  EXPECT_FALSE(is_rotate_case(path));
  std::ofstream(path) << "[body]\n";
  EXPECT_TRUE(is_rotate_case(path));
  EXPECT_THROW(is_rotate_case("/absent.toml"), InputError);
}

}  // namespace tdbd::simulation::rotate_case_test
