#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/random.hpp"
#include "io/archive.hpp"
#include "rotation/quaternion.hpp"
#include "simulation/rotate/rotate_case.hpp"
#include "simulation/rotate/rotate_simulation.hpp"
#include "verification/core/temporary_folder.hpp"
#include "verification/simulation/mesh_bit.hpp"
#include "verification/simulation/rotated_cases.hpp"

namespace tdbd::simulation::rotate_history_test {

namespace fs = std::filesystem;

constexpr const char* body_text = R"([body]
inertia = [[2, 0, 0], [0, 2.6, 0], [0, 0, 3]]
rotation_vector = [0.1, 0.2, 0.3]
angular_velocity = [0.7, -0.5, 2]
)";

constexpr const char* rest_text = R"([load]
gravity_moment = 3
stiffness = [0, 0, 0.1]
[time]
step = 0.01
duration = 6
)";

std::string cones_text(int count) {
  std::string text;
  for (int k = 0; k < count; ++k)
    text += "[[cones]]\naxis = [" + std::to_string(k) +
            ", 0.5, 0.6]\naxial_inertia = 0.1\nspin = " + std::to_string(3 * k - 4) + "\n";
  return text;
}

/// check_rotate_history.py opens the record of a case with so many cones, and finds in every row
/// what the variables have to do with each other.
void check_with_cones(int cones) {
  const fs::path where = tdbd::temporary_folder() + "tdbd_rotate_history_" + std::to_string(cones);
  fs::remove_all(where);
  fs::create_directories(where);
  std::ofstream(where / "case.toml") << body_text << cones_text(cones) << rest_text;
  const RotateCase c = read_rotate_case(where / "case.toml", {});
  RotateSimulation s = start(c);
  RotateHistory history(where / "history.nc", c);
  history.append(c, s);
  for (int i = 0; i < 600; ++i) {
    advance(c, s, 1);
    history.append(c, s);
    history.append(c, s);  // a step is there once
  }
  history.close();
  const std::string command = std::string("/usr/bin/python3 -B ") + TDBD_SOURCE_DIR +
                              "/verification/simulation/rotate/check_rotate_history.py " +
                              where.string() + " 601 " + std::to_string(cones);
  EXPECT_EQ(std::system(command.c_str()), 0) << cones << " cones";
}

TEST(RotateHistory, has_consistent_columns) {
  for (const int cones : {0, 1, 3}) check_with_cones(cones);
}

}  // namespace tdbd::simulation::rotate_history_test

namespace tdbd::simulation::rotate_checkpoint_test {

/// All numbers of a checkpoint, and everything else that a summary contains.
void expect_same(const RotateCase& c, const RotateSimulation& a, const RotateSimulation& b) {
  ArchiveWriter write_a, write_b;
  write_a(a);
  write_b(b);
  EXPECT_TRUE(std::move(write_a).archive().bytes == std::move(write_b).archive().bytes);
  EXPECT_EQ(summary_json(c, a, RunStatus::completed), summary_json(c, b, RunStatus::completed));
}

class RotateCheckpoints : public ::testing::TestWithParam<RotatedCase> {};

TEST_P(RotateCheckpoints, resume_bitwise_identically) {
  const RotateCase c = rotated_case(GetParam());
  Random random{20261123};
  for (int k = 0; k < 5; ++k) {
    const long before = static_cast<long>(random.uniform(0.0, 300.0)),
               after = static_cast<long>(random.uniform(1.0, 300.0));
    RotateSimulation whole = start(c);
    advance(c, whole, before);
    const auto file = test_folder() / "checkpoint.bin";
    write_rotate_checkpoint(file, c, whole, {7, before});
    RotateCheckpoint saved = read_rotate_checkpoint(file, c);
    EXPECT_EQ(saved.written.rows, 7);
    EXPECT_EQ(saved.written.last_step, before);
    expect_same(c, whole, saved.simulation);
    advance(c, whole, after);
    advance(c, saved.simulation, after);
    expect_same(c, whole, saved.simulation);
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, RotateCheckpoints, ::testing::ValuesIn(rotated_cases()),
                         [](const auto& instance) { return instance.param.name; });

TEST(RotateCheckpoint, names_what_changed_in_the_case) {
  const RotatedCase top = rotated_cases()[1];
  const RotateCase c = rotated_case(top);
  const auto file = test_folder() / "checkpoint.bin";
  write_rotate_checkpoint(file, c, start(c), {});
  try {
    read_rotate_checkpoint(file, rotated_case(top, {"time.step=0.005"}));
    FAIL() << "not refused";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(
                  "the case has changed since: [time] found step = 0.005, expected step = 0.01"),
              std::string::npos)
        << e.what();
  }
}

}  // namespace tdbd::simulation::rotate_checkpoint_test

namespace tdbd::simulation::rotate_summary_test {

using Json = nlohmann::json;
using dynamics::RotationState;

constexpr double rounding = 1e-12;  // momenta and energies of order ten

/// No two figures of this run are alike: loads in both frames, a driven cone, gravity, a winding
/// twist, energy that falls.
constexpr const char* case_text = R"([body]
inertia = [[2, 0, 0], [0, 2.6, 0], [0, 0, 3]]
rotation_vector = [0.3, -0.2, 0.1]
angular_velocity = [0.7, -0.5, 5]
[[cones]]
axis = [0.8, 0, 0.6]
axial_inertia = 0.1
spin = -7
angle = 0.4
torque = -0.3
[[cones]]
axis = [-0.4, 0.7, 0.6]
axial_inertia = 0.2
spin = 3
[load]
gravity_moment = -3
gravity_arm = [0.6, 0, 0.8]
body_torque = [0.1, 0.2, -1.5]
space_torque = [0.2, 0, 0.1]
[integrator]
drift = "three-axis"
drifts_per_step = 3
order = 4
[time]
step = 0.02
duration = 4
)";

/// The case, where it ended, and every state on its way.
struct Course {
  RotateCase c;
  RotateSimulation s;
  std::vector<RotationState> states;
};

const Course& the_run() {
  static const Course run = [] {
    const std::string path = tdbd::temporary_folder() + "rotate_summary.toml";
    std::ofstream(path) << case_text;
    Course r;
    r.c = read_rotate_case(path, {});
    r.s = start(r.c);
    r.states = {r.s.rotating.state};
    advance(r.c, r.s, r.c.time.steps);
    RotateSimulation one_by_one = start(r.c);
    while (one_by_one.steps_done < r.c.time.steps) {
      advance(r.c, one_by_one, 1);
      r.states.push_back(one_by_one.rotating.state);
    }
    return r;
  }();
  return run;
}

Json summary() { return Json::parse(summary_json(the_run().c, the_run().s, RunStatus::completed)); }

Vec3 vector_of(const Json& j) {
  return Vec3(j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>());
}

/// Largest value of a quantity over the run.
template <class Quantity>
double largest(Quantity quantity) {
  double found = 0.0;
  for (const RotationState& s : the_run().states) found = std::max(found, quantity(s));
  return found;
}

void expect_near(const Json& found, double expected) {
  EXPECT_NEAR(found.get<double>(), expected, rounding);
}

TEST(RotateSummary, has_the_attitude_and_the_momenta_of_the_end_in_their_frames) {
  const RotationState& first = the_run().states.front();
  const RotationState& last = the_run().states.back();
  const Json j = summary();
  const Mat3 R = last.q_WB.toRotationMatrix();
  for (int i = 0; i < 3; ++i)
    EXPECT_LE((vector_of(j["attitude"][i]) - R.row(i).transpose()).norm(), rounding);
  EXPECT_EQ(vector_of(j["space_momentum"]), last.momentum_W);
  EXPECT_EQ(vector_of(j["space_momentum_start"]), first.momentum_W);
  EXPECT_LE((vector_of(j["body_momentum"]) - R.transpose() * last.momentum_W).norm(), rounding);
  EXPECT_EQ(j["cone_angles"].get<std::vector<double>>(), last.cone_angles);
  EXPECT_EQ(j["cone_momenta"].get<std::vector<double>>(), last.cone_momenta);
  EXPECT_GT(last.turns, 0);
  expect_near(j["twist_rad"], rotation::twist_angle(last.q_WB, last.turns));
}

/// Pi = It W + sum_k pi_k s_k and pi_k = Ic_k (phi_k' + s_k . W).
TEST(RotateSummary, has_velocities_that_belong_to_the_momenta) {
  const dynamics::Gyrostat& g = the_run().c.body;
  const Json j = summary();
  const Vec3 w_B = vector_of(j["angular_velocity"]);
  Vec3 momentum_B = g.carrier_B * w_B;
  for (std::size_t k = 0; k < g.cones.size(); ++k) {
    const double spin = j["cone_spins"][k], momentum = j["cone_momenta"][k];
    EXPECT_NEAR(momentum, g.cones[k].axial_inertia * (spin + g.cones[k].axis_B.dot(w_B)), rounding);
    momentum_B += momentum * g.cones[k].axis_B;
  }
  EXPECT_LE((momentum_B - vector_of(j["body_momentum"])).norm(), rounding);
}

TEST(RotateSummary, has_energies_and_their_changes_over_the_scale) {
  const Course& r = the_run();
  const auto energy = [&](const RotationState& s) {
    return dynamics::kinetic_energy(r.c.body, s) + dynamics::potential_energy(r.c.loads, s);
  };
  const double at_start = energy(r.states.front()), at_end = energy(r.states.back());
  const double scale = dynamics::kinetic_energy(r.c.body, r.states.front()) +
                       std::abs(dynamics::potential_energy(r.c.loads, r.states.front())) + 3.0;
  const Json j = summary();
  expect_near(j["energy_start"], at_start);
  expect_near(j["energy_end"], at_end);
  expect_near(j["energy_scale"], scale);
  expect_near(j["energy_drift_end"], (at_end - at_start) / scale);
  expect_near(j["energy_drift_max"], largest([&](const RotationState& s) {
                return std::abs(energy(s) - at_start) / scale;
              }));
}

TEST(RotateSummary, has_the_largest_changes_of_the_momenta) {
  const RotationState& first = the_run().states.front();
  const auto change = [&](const RotationState& s) { return Vec3(s.momentum_W - first.momentum_W); };
  const Json j = summary();
  expect_near(j["momentum_drift_max"],
              largest([&](const RotationState& s) { return change(s).norm(); }));
  expect_near(j["vertical_momentum_drift_max"],
              largest([&](const RotationState& s) { return std::abs(change(s).z()); }));
  expect_near(j["cone_momentum_drift_max"], largest([&](const RotationState& s) {
                return std::abs(s.cone_momenta[0] - first.cone_momenta[0]);
              }));
  EXPECT_EQ(j["unit_quaternion_defect_max"].get<double>(),
            largest([](const RotationState& s) { return std::abs(s.q_WB.squaredNorm() - 1.0); }));
}

TEST(RotateSummary, has_the_steps_and_their_integrator) {
  const Json j = summary();
  EXPECT_EQ(j["steps"], 200);
  EXPECT_EQ(j["step_s"], 0.02);
  EXPECT_EQ(j["duration_s"], 4.0);
  EXPECT_EQ(j["torque_evaluations"], 1 + 200 * 5);  // Suzuki's five stages
  EXPECT_EQ(j["integrator"], Json({{"drift", "three-axis"}, {"drifts_per_step", 3}, {"order", 4}}));
}

/// What does not move has no energy to compare with.
TEST(RotateSummary, a_body_at_rest_has_an_energy_scale_of_one) {
  const std::string path = tdbd::temporary_folder() + "rotate_summary_rest.toml";
  std::ofstream(path) << "[body]\ninertia = [[1,0,0],[0,1,0],[0,0,1]]\n"
                         "[time]\nstep = 1\nduration = 1\n";
  const RotateCase c = read_rotate_case(path, {});
  RotateSimulation s = start(c);
  advance(c, s, 1);
  const Json j = Json::parse(summary_json(c, s, RunStatus::completed));
  EXPECT_EQ(j["energy_scale"], 1.0);
  EXPECT_EQ(j["energy_drift_max"], 0.0);
}

}  // namespace tdbd::simulation::rotate_summary_test
