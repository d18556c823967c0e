#include "reference/compare/models/free_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/compare/comparison.hpp"

namespace tdbd::reference::free_run_test {
namespace {

constexpr double load = 16e3, damping = 5e5, started = 15.0 / 3600.0, sideways = 5e7;

/// Bit B on a string in a coarse rock.
const Comparison& of_three() {
  static const Comparison all = [] {
    const CompareCase c =
        read_compare_case(TDBD_SOURCE_DIR "/cases/compare/bit-b-free.toml",
                          {"rock.edge_length='3 mm'", "time.step='2 ms'", "time.duration='2 s'"});
    return compare(c, chosen_models(c, {"all"}), Refusal::stops, {});
  }();
  return all;
}

double said(const Answer& a, Quantity q) {
  return saying(a.findings, q).value.value_or(std::nan(""));
}

TEST(FreeRun, three_models_answer_and_the_others_say_what_they_need) {
  ASSERT_EQ(of_three().answers.size(), 3);
  EXPECT_EQ(of_three().answers[1].model->name, "langeveld");
  EXPECT_EQ(of_three().answers[2].model->name, "hanson-hansen");
  EXPECT_EQ(of_three().not_asked.size(), models().size() - 3);
  EXPECT_EQ(
      of_three().not_asked.front(),
      "Warren and Sinor: found motion.kind = \"drilling\", needs a bit whose motion is given");
}

TEST(FreeRun, the_rock_carries_the_load_less_what_the_damper_takes) {
  constexpr double tolerance = 2e-3;
  for (const Answer& a : of_three().answers) {
    const double carried = load - damping * (said(a, Quantity::rate_of_penetration) - started);
    EXPECT_NEAR(said(a, Quantity::weight) / carried, 1.0, tolerance) << a.model->name;
    EXPECT_EQ(of_three().weight, load);
    EXPECT_EQ(said(a, Quantity::rate_at_weight), said(a, Quantity::rate_of_penetration));
  }
}

/// Weight and torque do eps times the volume that goes, also where the bit finds its own rate.
TEST(FreeRun, weight_and_torque_do_the_work_of_the_rock_that_goes) {
  // seen: 0.004
  constexpr double tolerance = 0.01, eps = 100e6, gage = 0.10795;
  for (const Answer& a : of_three().answers) {
    const double advance = 0.5 * said(a, Quantity::rate_of_penetration);
    EXPECT_NEAR(said(a, Quantity::work_of_a_turn_torque) / (eps * gage * gage * advance / 2.0), 1.0,
                tolerance)
        << a.model->name;
    EXPECT_NEAR(
        said(a, Quantity::removed_per_revolution) / (std::numbers::pi * gage * gage * advance), 1.0,
        tolerance)
        << a.model->name;
  }
}

TEST(FreeRun, finds_rates_that_agree) {
  constexpr double tolerance = 0.015;  // seen: 0.006
  const double ours = said(of_three().answers[0], Quantity::rate_of_penetration);
  for (const Answer& a : of_three().answers)
    EXPECT_NEAR(said(a, Quantity::rate_of_penetration) / ours, 1.0, tolerance) << a.model->name;
}

/// The side force turns slowly against the string's own frequency: it pushes as far as the spring gives way.
TEST(FreeRun, whirls_as_far_as_its_side_force_bends_the_string) {
  constexpr double tolerance = 0.04;  // seen: 0.024
  for (const Answer& a : of_three().answers)
    EXPECT_NEAR(said(a, Quantity::whirl_radius) * sideways / said(a, Quantity::side_force), 1.0,
                tolerance)
        << a.model->name;
}

/// A top that is lowered: the bit follows it, and its weight is that of a bit led at this rate.
TEST(FreeRun, a_lowered_bit_finds_its_weight) {
  const CompareCase c = read_compare_case(
      TDBD_SOURCE_DIR "/cases/compare/bit-b.toml",
      {"motion.kind='drilling'", "string.axial_stiffness='5e7 N/m'", "string.mass='1000 kg'",
       "string.axial_damping='5e5 N s/m'", "string.torsional_stiffness='1e5 N m/rad'",
       "string.torsional_inertia='100 kg m2'", "string.lateral_stiffness='5e7 N/m'",
       "string.bending_inertia='100 kg m2'", "motion.torque_at_start='1200 N m'",
       "motion.weight_at_start='16 kN'"});
  const CompareCase given = read_compare_case(TDBD_SOURCE_DIR "/cases/compare/bit-b.toml", {});
  const Comparison all = compare(c, chosen_models(c, {"langeveld"}), Refusal::stops, {}),
                   led = compare(given, chosen_models(given, {"langeveld"}), Refusal::stops, {});
  const Answer& a = all.answers.front();
  constexpr double tolerance = 0.02;
  EXPECT_NEAR(said(a, Quantity::rate_of_penetration) / started, 1.0, tolerance);
  EXPECT_NEAR(said(a, Quantity::weight) / said(led.answers.front(), Quantity::weight), 1.0,
              tolerance);
  EXPECT_FALSE(saying(a.findings, Quantity::rate_at_weight).value);
  EXPECT_EQ(all.weight_from, "Langeveld");
}

TEST(FreeRun, a_led_bit_has_no_rate_of_its_own) {
  const CompareCase c =
      read_compare_case(TDBD_SOURCE_DIR "/cases/compare/bit-b.toml", {"time.revolutions=2"});
  const Comparison all = compare(c, chosen_models(c, {"warren-sinor"}), Refusal::stops, {});
  EXPECT_EQ(saying(all.answers.front().findings, Quantity::rate_of_penetration).reason,
            "given: the case moves the bit");
}

/// Without lateral damping; the models that have it go on.
TEST(FreeRun, a_bit_that_whirls_off_its_spokes_is_refused_by_its_models_name) {
  const CompareCase c =
      read_compare_case(TDBD_SOURCE_DIR "/cases/compare/bit-b-free.toml",
                        {"string.lateral_stiffness='1e7 N/m'", "time.duration='5 s'"});
  const Comparison all = compare(c, {&models()[4]}, Refusal::is_noted, {});
  EXPECT_TRUE(all.answers.empty());
  EXPECT_EQ(all.not_asked.front().find("Langeveld: found a bit that whirls"), 0)
      << all.not_asked.front();
}

TEST(FreeRun, a_step_too_long_for_the_damper_is_refused_by_its_models_name) {
  const CompareCase c = read_compare_case(TDBD_SOURCE_DIR "/cases/compare/bit-b-free.toml",
                                          {"string.axial_damping='5e6 N s/m'"});
  try {
    compare(c, chosen_models(c, {"langeveld"}), Refusal::stops, {});
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()).find("Langeveld: found a "), 0) << e.what();
  }
}

}  // namespace
}  // namespace tdbd::reference::free_run_test
