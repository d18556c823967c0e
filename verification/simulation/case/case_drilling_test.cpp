#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "bit/bit.hpp"
#include "bit/cone/cone_measures.hpp"
#include "core/error.hpp"
#include "core/temporary_file.hpp"
#include "forces/laws/laws.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/drilling_settings.hpp"

namespace tdbd::simulation::case_drilling_test {

Case with(std::vector<std::string> settings) {
  settings.insert(settings.end(), {"rock.edge_length='5 mm'", "time.duration='0.1 s'"});
  return read_case(TDBD_SOURCE_DIR "/cases/drill-bit-b.toml", settings);
}

/// A file without the lines that begin with `key`.
std::string without_line(const std::string& text, const std::string& key) {
  std::istringstream in(text);
  std::string left;
  for (std::string line; std::getline(in, line);)
    if (!line.starts_with(key)) left += line + "\n";
  return left;
}

/// No two numbers are alike.
const std::vector<std::string> all_different{
    "string.mass=900",
    "string.torsional_inertia=11",
    "string.bending_inertia=13",
    "string.attachment_height=0.05",
    "string.lateral_stiffness=4e7",
    "string.axial_stiffness=3e6",
    "string.bending_stiffness=2e6",
    "string.torsional_stiffness=6000",
    "string.lateral_damping=1.5e5",
    "string.axial_damping=2.5e5",
    "string.bending_damping=1100",
    "string.torsional_damping=60",
    "string.dampers_to=space",
    "string.gravity=9.5",
    "wall={stiffness=1e6, clearance=0.002, ring_radius=0.09, ring_height=0.3, restitution=0.7, "
    "friction=0.25, slip_speed=0.004}",
    "rock_mount={mass=280, stiffness=5e5, damping=700}",
    "motion.weight_at_start=20000",
    "motion.torque_at_start=2400"};

void expect_about_z(const Mat3& m, double lateral, double axial) {
  EXPECT_EQ(m, Mat3(Vec3(lateral, lateral, axial).asDiagonal()));
}

TEST(ReadDrilling, gives_the_string_its_springs_and_dampers) {
  const dynamics::DrillString s = with(all_different).drilling.system.string;
  EXPECT_EQ(s.attachment_B, Vec3(0.0, 0.0, -0.05));
  expect_about_z(s.stiffness, 4e7, 3e6);
  expect_about_z(s.damping, 1.5e5, 2.5e5);
  expect_about_z(s.turn_stiffness, 2e6, 6000.0);
  expect_about_z(s.turn_damping, 1100.0, 60.0);
  EXPECT_EQ(s.damper_end, dynamics::DamperEnd::space);
}

/// A bit hung there neither topples nor rights itself.
TEST(ReadDrilling, attaches_the_string_at_the_centre_of_mass_by_default) {
  const Case c = read_case(TDBD_SOURCE_DIR "/cases/drill-bit-r.toml", {});
  const Case hung =
      read_case(write_temporary(".toml", without_line(c.resolved, "attachment_height")), {});
  EXPECT_EQ(hung.drilling.system.string.attachment_B,
            Vec3(0.0, 0.0, bit::mass_properties(c.bit).centre.z()));
  const Case again = read_case(write_temporary("_again.toml", hung.resolved), {});
  EXPECT_EQ(again.drilling.system.string.attachment_B, hung.drilling.system.string.attachment_B);
  EXPECT_EQ(c.drilling.system.string.attachment_B, Vec3(0.0, 0.0, 0.0));
}

TEST(ReadDrilling, sets_the_numbers_of_wall_and_mount) {
  const dynamics::DrillingSystem s = with(all_different).drilling.system;
  EXPECT_EQ(s.gravity, 9.5);
  EXPECT_EQ(s.wall.stiffness, 1e6);
  EXPECT_EQ(s.wall.clearance, 0.002);
  EXPECT_EQ(s.wall.ring_radius, 0.09);
  EXPECT_EQ(s.wall.ring_z_B, -0.3);
  EXPECT_EQ(s.wall.restitution, 0.7);
  EXPECT_EQ(s.wall.friction, 0.25);
  EXPECT_EQ(s.wall.slip_speed, 0.004);
  EXPECT_EQ(s.rock.mass, 280.0);
  EXPECT_EQ(s.rock.stiffness, 5e5);
  EXPECT_EQ(s.rock.damping, 700.0);
}

/// Gage pads bear as much as crushes the rock. A law of their own replaces that.
TEST(ReadDrilling, gives_gage_pads_a_law_where_the_wall_is_the_rock) {
  const Case c = with({"wall={model='rock', friction=0.8, slip_speed=0.02}"});
  EXPECT_EQ(c.drilling.system.wall.stiffness, 0.0);
  const auto& pads = std::get<forces::Friction>(law_of(c.forces, bit::PartKind::gage_pad));
  EXPECT_EQ(pads.mu, 0.8);
  EXPECT_EQ(pads.slip_speed, 0.02);
  EXPECT_EQ(pads.cap, 1.5);
  EXPECT_GT(pads.stress, 1e30);
  const Case own =
      with({"wall={model='rock'}", "forces.gage_pad={law='friction', stress=1e6, mu=0.1}"});
  EXPECT_EQ(std::get<forces::Friction>(law_of(own.forces, bit::PartKind::gage_pad)).stress, 1e6);
  EXPECT_EQ(std::get<forces::Friction>(law_of(with({}).forces, bit::PartKind::gage_pad)).mu, 0.3);
  EXPECT_FALSE(
      has_law(with({"wall={stiffness=1e8, clearance='3 mm'}"}).forces, bit::PartKind::gage_pad));
}

TEST(ReadDrilling, adds_the_string_to_the_bit) {
  const Case c =
      with({"string.mass=900", "string.torsional_inertia=11", "string.bending_inertia=13"});
  const dynamics::DrillingSystem& s = c.drilling.system;
  const dynamics::DrillingSystem more =
      with({"string.mass=1900", "string.torsional_inertia=31", "string.bending_inertia=23"})
          .drilling.system;
  EXPECT_NEAR(more.mass, s.mass + 1000.0, 1e-12);
  EXPECT_EQ(more.centre_B, s.centre_B);
  const Mat3 added = more.gyrostat.inertia_B - s.gyrostat.inertia_B;
  EXPECT_LT((added - Mat3(Vec3(10.0, 10.0, 20.0).asDiagonal())).norm(), 1e-13);
  const double bit = bit::mass_properties(c.bit).mass;
  EXPECT_NEAR(s.mass, bit + 900.0, 1e-12);
}

/// Its springs carry the loads of the case minus the weight of the bit.
TEST(ReadDrilling, starts_with_a_string_that_carries_its_weight_and_torque) {
  const Case c = with(all_different);
  const dynamics::DrillingSystem& s = c.drilling.system;
  EXPECT_DOUBLE_EQ(s.top.start_angle, 2400.0 / 6000.0);
  const Vec3 slack = s.string.rest_W - (c.motion.start_W + s.string.attachment_B);
  EXPECT_EQ(slack.head<2>(), Eigen::Vector2d(0.0, 0.0));
  EXPECT_NEAR(slack.z(), (20000.0 - s.mass * 9.5) / 3e6, 1e-12);
  EXPECT_EQ(c.drilling.start.c_W, Vec3(c.motion.start_W + s.centre_B));
}

TEST(ReadDrilling, starts_with_the_motion_of_the_top) {
  const Case c = with({"motion.start=[0.001, 0.002, -0.003]"});
  const dynamics::DrillingSystem& s = c.drilling.system;
  const dynamics::DrillingState& start = c.drilling.start;
  EXPECT_LT((start.c_W - Vec3(0.001, 0.002, -0.003) - s.centre_B).norm(), 1e-15);
  const Vec3 w(0.0, 0.0, c.motion.rotary_speed);
  EXPECT_LT(
      (start.momentum_W / s.mass - Vec3(0.0, 0.0, 25.0 / 3600.0) - w.cross(s.centre_B)).norm(),
      1e-12);
}

/// Cones roll from the start: they turn against the bit as their gage rows do, and are carried by it.
TEST(ReadDrilling, starts_with_cones_that_roll) {
  const Case c = read_case(TDBD_SOURCE_DIR "/cases/drill-bit-r.toml",
                           {"rock.edge_length='6 mm'", "time.duration='0.1 s'",
                            "string.bearing_damping=0.75", "motion.rotary_speed='90 rpm'"});
  const dynamics::DrillingSystem& s = c.drilling.system;
  const dynamics::RotationState& start = c.drilling.start.rotation;
  ASSERT_EQ(c.bit.cones.size(), 3u);
  EXPECT_EQ(s.bearing_damping, std::vector<double>(3, 0.75));
  EXPECT_EQ(start.cone_angles, std::vector<double>(3, 0.0));
  for (std::size_t k = 0; k < 3; ++k) {
    const bit::Cone& cone = c.bit.cones[k];
    const double inertia = bit::cone_mass(c.bit, static_cast<int>(k)).axial_inertia;
    const Vec3 axis = cone.X_BK.R.col(2);
    EXPECT_LT((s.gyrostat.cones[k].axis_B - axis).norm(), 1e-15);
    EXPECT_DOUBLE_EQ(s.gyrostat.cones[k].axial_inertia, inertia);
    const double spin = -bit::rolling_ratio_of_gage_row(cone) * c.motion.rotary_speed;
    EXPECT_LT(spin * axis.z(), 0.0);
    EXPECT_NEAR(start.cone_momenta[k], inertia * (spin + axis.z() * c.motion.rotary_speed),
                1e-12 * inertia * std::abs(spin));
  }
}

std::string refusal(const std::vector<std::string>& settings) {
  try {
    with(settings);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(ReadDrilling, rejects_a_start_that_the_string_cannot_carry) {
  EXPECT_NE(refusal({"motion.weight_at_start=10"})
                .find("motion.weight_at_start: found 10 N, expected an axial stiffness"),
            std::string::npos);
  EXPECT_NE(refusal({"string.torsional_stiffness=0", "motion.torque_at_start=10"})
                .find("motion.torque_at_start: found 10 N m, expected a torsional stiffness"),
            std::string::npos);
  EXPECT_EQ(refusal({"string.torsional_stiffness=0", "motion.torque_at_start=0"}), "");
}

/// A wrong case may have senseless stiffnesses: only when all else is right is its step judged.
TEST(ReadDrilling, requires_a_stable_step_if_all_else_is_right) {
  const std::string stiff = "string.lateral_stiffness='1e10 N/m'",
                    wrong = "measure.section_every=4";
  EXPECT_NE(refusal({stiff}).find("expected a stable step"), std::string::npos);
  EXPECT_NE(refusal({stiff, wrong}).find("measure.section_every: found 4"), std::string::npos);
  EXPECT_EQ(refusal({stiff, wrong}).find("expected a stable step"), std::string::npos);
}

}  // namespace tdbd::simulation::case_drilling_test
