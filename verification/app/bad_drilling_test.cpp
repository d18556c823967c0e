#include <gtest/gtest.h>

#include "app/small_case.hpp"

namespace tdbd::app::bad_drilling_test {

/// One wrong setting of a shipped case, and the message about it.
struct Wrong {
  const char* name;
  const char* file;
  std::vector<std::string> settings;
  const char* message;
};

void PrintTo(const Wrong& w, std::ostream* out) { *out << w.name; }

class BadDrilling : public ::testing::TestWithParam<Wrong> {};

TEST_P(BadDrilling, is_rejected_with_its_place_and_reason) {
  std::vector<std::string> arguments{
      "check", TDBD_SOURCE_DIR "/cases/" + std::string(GetParam().file) + ".toml"};
  for (const std::string& s : GetParam().settings) {
    arguments.emplace_back("--set");
    arguments.push_back(s);
  }
  const battery::Outcome o = battery::run_tdbd(arguments);
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find(GetParam().message), std::string::npos) << o.err;
}

/// The small case, whose bit drills under a weight or at a rate.
SmallCaseWithForces drilling(const std::string& axial, const std::string& string) {
  SmallCaseWithForces c(string);
  c.edit("case.toml", "rate_of_penetration = \"30 m/h\"", "kind = \"drilling\"\n" + axial);
  return c;
}

const std::string weight = "weight_on_bit = \"1 kN\"", rate = "rate_of_penetration = \"3 m/h\"";

/// All stiffnesses are 0 by default, and the bit would never turn.
TEST(MissingString, is_rejected_with_a_typical_one) {
  expect_refused(
      drilling(weight, ""),
      "case.toml:1: string: found no table [string], so that nothing would turn the bit, "
      "expected the string between the bit and its top drive, for example mass = \"1000 "
      "kg\", torsional_inertia = \"10 kg m2\", bending_inertia = \"10 kg m2\", "
      "lateral_stiffness = \"5e7 N/m\", lateral_damping = \"2e5 N s/m\", axial_damping = "
      "\"2e5 N s/m\", torsional_stiffness = \"5000 N m/rad\", torsional_damping = \"50 N "
      "m s/rad\", bending_stiffness = \"1e6 N m/rad\", bending_damping = \"1e3 N m "
      "s/rad\"; `tdbd new drilling NAME` writes a complete case");
}

TEST(MissingString, without_a_stiffness_is_rejected_with_its_key) {
  expect_refused(
      drilling(weight, "[string]\nmass = 1000\n"),
      "case.toml:19: string.torsional_stiffness: found none, so that the string would not move the "
      "bit, expected the stiffness through which the top turns the bit, for example \"5000 N "
      "m/rad\" "
      "(500 to 10 000 N m/rad), or 0 if nothing connects them; `tdbd new drilling NAME` writes a "
      "complete case");
  expect_refused(
      drilling(rate, "[string]\nmass = 1000\ntorsional_stiffness = 5000\n"),
      "case.toml:19: string.axial_stiffness: found none, so that the string would not move the "
      "bit, "
      "expected the stiffness through which the top, lowered at a rate, loads the bit, for example "
      "\"1e6 N/m\" (2e5 to 1e7 N/m), or 0 if nothing connects them; `tdbd new drilling NAME` "
      "writes "
      "a complete case");
}

TEST(MissingString, is_accepted_if_the_case_states_that_it_is_0) {
  EXPECT_EQ(drilling(weight, "[string]\ntorsional_stiffness = 0\n").check().exit_code, 0);
  EXPECT_EQ(
      drilling(rate, "[string]\ntorsional_damping = 10\naxial_stiffness = 0\n").check().exit_code,
      0)
      << "a damper that ends at the top turns the bit";
}

const Wrong wrongs[] = {
    {"an_unknown_law",
     "drill-bit-b",
     {"forces.law=detournoi"},
     "--set: forces.law: found \"detournoi\", expected one of none, hanson-hansen, detournay"},
    {"a_string_beyond_all_numbers",
     "stick-slip",
     {"string.mass=1e300 kg"},
     "--set: string.mass: found \"1e300 kg\", expected mass in kg, in [0, 1e+16]"},
    {"a_wall_beyond_all_numbers",
     "drill-bit-b-whirl",
     {"wall.stiffness=1e300"},
     "--set: wall.stiffness: found 1e+300, expected "},
    {"a_mount_beyond_all_numbers",
     "high-frequency-beds",
     {"rock_mount.damping=1e300"},
     "--set: rock_mount.damping: found 1e+300, expected "},
    {"a_pull_of_no_planet",
     "stick-slip",
     {"string.gravity=1e6 m/s2"},
     "--set: string.gravity: found \"1e6 m/s2\", expected acceleration in m/s2, in [0, 100]"},
    {"a_string_held_in_the_sky",
     "stick-slip",
     {"string.attachment_height=1 km"},
     "--set: string.attachment_height: found \"1 km\", expected length in m, in [-100, 100]"},
    {"a_hole_as_wide_as_a_town",
     "drill-bit-b-whirl",
     {"wall.clearance=1 km"},
     "--set: wall.clearance: found \"1 km\", expected length in m, in [0, 10]"},
    {"a_ring_as_wide_as_a_town",
     "drill-bit-b-whirl",
     {"wall.ring_radius=1 km"},
     "--set: wall.ring_radius: found \"1 km\", expected length in m, in (0, 10]"},
    {"a_wall_that_nothing_slips_on",
     "drill-bit-b-whirl",
     {"wall.friction=1e6"},
     "--set: wall.friction: found 1000000.0, expected a plain number, in [0, 10]"},
    {"a_wall_of_rock_with_a_ring",
     "drill-bit-b-whirl",
     {"wall.model=rock"},
     "wall.clearance: found a key of a ring, expected wall.model = \"ring\", or only friction and "
     "slip_speed"},
    {"a_ring_without_a_clearance", "drill-bit-b", {"wall.stiffness=1e8"}, "wall.clearance: "},
    {"a_wall_of_rock_and_a_law_for_pads",
     "drill-bit-b-whirl-rock",
     {"forces.gage_pad={law='friction', stress=1e6, mu=0.1}"},
     "wall.friction: found [forces.gage_pad] as well, expected one of the two"},
    {"a_wall_of_rock_that_no_pad_touches",
     "drill-bit-m",
     {"wall.model=rock"},
     "wall.model: found \"rock\" and a bit without gage pads, expected gage pads that bear on the "
     "wall ([gage_pads] of the bit file), or \"ring\""},
    {"a_torque_beyond_all_numbers",
     "drill-bit-b",
     {"motion.torque_at_start=1e300"},
     "--set: motion.torque_at_start: found 1e+300, expected torque"},
    {"a_rate_that_is_remembered_for_less_than_no_time",
     "drill-bit-b",
     {"motion.rate_memory=-1"},
     "--set: motion.rate_memory: found -1, expected time in s, >= 0"},
    {"a_rock_of_pores_alone",
     "drill-bit-b",
     {"rock.material={unconfined_strength='50 MPa', friction_angle='30 deg', porosity=1}"},
     "--set: rock.material.porosity: found 1, expected a plain number, in [0, 0.9]"},
    {"a_missing_coefficient",
     "bit-b-3000psi",
     {"forces.gage_pad.law=friction", "forces.gage_pad.mu=0.3"},
     "forces.gage_pad.stress: found nothing, expected pressure in Pa"},
    {"a_law_for_a_part_that_it_does_not_know",
     "bit-b-3000psi",
     {"forces.face.law=friction", "forces.face.mu=0.3", "forces.face.stress='1 MPa'"},
     "--set: forces.face.law: found friction, expected the law \"friction\" does not apply to "
     "face"},
    {"a_law_that_knows_no_part_of_the_bit",
     "drill-bit-r",
     {"forces.law=depth-of-cut", "forces.kn='1 MPa'", "forces.kt='1 MPa'"},
     "--set: forces.law: found depth-of-cut, expected a law that acts on a part of this bit "
     "(gage pad, bit body, cone, tooth): friction, indentation"},
    {"a_weight_that_nothing_bears",
     "drill-bit-b",
     {"forces={law='none', cutter_body={law='none'}}"},
     "motion.weight_on_bit: found 3e+04 N, expected 0 N: no part of the bit has a force law that "
     "carries weight"},
    {"a_face_without_a_cutter",
     "outside-bit",
     {"rock.material=mancos-shale", "forces.coefficients=hanson-hansen-shale"},
     ", a part without a cutter whose place is known, expected a cutter table, or the frame of its "
     "cutter (cutter_position of [[solids.rules]], position and rotation_vector of [[parts]]) with "
     "a face flat across X; or forces.face.law = \"none\""},
    {"forces_without_sections",
     "bit-b-3000psi",
     {"measure.section=off"},
     "found measure.section = \"off\", expected sections, from which the forces of cutters are "
     "computed"},
    {"sections_in_turn_of_a_bit_that_forces_move",
     "drill-bit-b",
     {"measure.section_every=4"},
     "--set: measure.section_every: found 4, expected 1 if forces move the bit"},
    {"an_unknown_rock",
     "drill-bit-b",
     {"rock.material=cheese"},
     "--set: rock.material: found \"cheese\", expected one of berea-sandstone"},
    {"a_weight_and_a_rate",
     "drill-bit-b",
     {"motion.rate_of_penetration='15 m/h'"},
     "motion: found weight_on_bit and rate_of_penetration, expected weight_on_bit or "
     "rate_of_penetration"},
    {"a_schedule_of_unlike_lengths",
     "laboratory",
     {"motion.weight_on_bit.times=[0,1]"},
     "motion.weight_on_bit.times: found 2 times for 3 values"},
    {"a_torque_that_nothing_carries",
     "drill-bit-b",
     {"string.torsional_stiffness=0"},
     "motion.torque_at_start: found 2600 N m, expected a torsional stiffness that carries it"},
    {"a_stiffness_that_the_step_does_not_follow",
     "drill-bit-b",
     {"string.lateral_stiffness='1e10 N/m'"},
     "time.step: found 0.001 s, expected a stable step: "},
    {"a_load_that_no_bit_carries",
     "drill-bit-b",
     {"motion.weight_on_bit='30 GN'"},
     "motion.weight_on_bit: found 3e+10 N, expected at most "},
    {"an_unknown_order",
     "drill-bit-b",
     {"output.energy_order=sometimes"},
     "--set: output.energy_order: found \"sometimes\", expected one of on, off, always"},
    {"a_window_too_short_for_an_order",
     "drill-bit-b",
     {"output.energy_order_window=2"},
     "--set: output.energy_order_window: found 2, expected"},
    {"an_order_where_nothing_is_driven",
     "bit-b-steady",
     {"output.energy_order=on"},
     "--set: output.energy_order: "},
    {"a_node_outside_the_string",
     "string-drill-bit-b",
     {"output.string_depths=['0 m', '2600 m']"},
     "--set: output.string_depths: found 2600 m, expected depths of the string, 0 to 2500 m"},
    {"nodes_of_a_lumped_string",
     "drill-bit-b",
     {"output.string_depths=['0 m']"},
     "--set: output.string_depths: found a key of a chain, expected none, or string.model = "
     "\"chain\""},
    {"profiles_of_a_bit_without_a_string",
     "bit-b-steady",
     {"output.string_profile_every='1 s'"},
     "--set: output.string_profile_every: found a key of a chain, expected none, or string.model = "
     "\"chain\""},
    {"a_log_of_a_rig_for_a_lumped_string",
     "drill-bit-b",
     {"string.top.log={file='" TDBD_SOURCE_DIR "/cases/string-rig-log.las', rotary_speed='RPM'}"},
     "string.top.log.file: found a log of the rig without string.model = \"chain\", expected none, "
     "or that model"},
    {"a_log_with_gaps",
     "string-drill-bit-b",
     {"string.top.log={file='" TDBD_SOURCE_DIR
      "/cases/string-rig-log.las', time='TIME', hook_load='HKLA [kN]', start='60 s'}",
      "string.top.axial=hook-load"},
     "string-rig-log.las:23: HKLA: found no value, \"-999.25\", expected a number in each row: "
     "fill "
     "the gap or cut the record"},
    {"a_speed_beside_that_of_a_log",
     "string-drill-bit-b",
     {"string.top.log={file='" TDBD_SOURCE_DIR
      "/cases/string-rig-log.las', time='TIME', rotary_speed='RPM', start='55 s'}"},
     "motion.rotary_speed: found a value in addition to that of the log, expected one of the two"},
    {"no_time_between_profiles",
     "string-drill-bit-b",
     {"output.string_profile_every=0"},
     "--set: output.string_profile_every: found 0, expected time in s, > 0"},
    {"a_first_step_of_a_bit_that_forces_move",
     "drill-bit-b",
     {"time.first_step=5"},
     "time.first_step: found 5 of a bit that forces move"},
};

INSTANTIATE_TEST_SUITE_P(One, BadDrilling, ::testing::ValuesIn(wrongs),
                         [](const auto& w) { return std::string(w.param.name); });

}  // namespace tdbd::app::bad_drilling_test
