#include "reference/compare/models/free_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/compare/comparison.hpp"
#include "reference/compare/models/free_string.hpp"
#include "verification/literature/compare/model_runs.hpp"

namespace tdbd::reference::free_run_test {

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

TEST(FreeRun, three_models_run_and_the_others_report_what_they_need) {
  ASSERT_EQ(of_three().answers.size(), 3);
  EXPECT_EQ(of_three().answers[1].model->name, "langeveld");
  EXPECT_EQ(of_three().answers[2].model->name, "hanson-hansen");
  EXPECT_EQ(of_three().excluded_models.size(), models().size() - 3);
  EXPECT_EQ(
      of_three().excluded_models.front(),
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

/// The side force turns slowly compared with the frequency of the string, so that the displacement
/// is that of the spring under a static force.
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

/// Without lateral damping; the models with damping continue.
TEST(FreeRun, a_bit_that_whirls_off_its_spokes_is_rejected_by_its_models_name) {
  const CompareCase c =
      read_compare_case(TDBD_SOURCE_DIR "/cases/compare/bit-b-free.toml",
                        {"string.lateral_stiffness='1e7 N/m'", "time.duration='5 s'"});
  const Comparison all = compare(c, {&models()[4]}, Refusal::is_noted, {});
  EXPECT_TRUE(all.answers.empty());
  EXPECT_EQ(all.excluded_models.front().find("Langeveld: found a bit that whirls"), 0)
      << all.excluded_models.front();
}

TEST(FreeRun, a_step_too_long_for_the_damper_is_rejected_by_its_models_name) {
  const CompareCase c = read_compare_case(TDBD_SOURCE_DIR "/cases/compare/bit-b-free.toml",
                                          {"string.axial_damping='5e6 N s/m'"});
  try {
    compare(c, chosen_models(c, {"langeveld"}), Refusal::stops, {});
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()).find("Langeveld: found a "), 0) << e.what();
  }
}

const std::string bit_b_free = TDBD_SOURCE_DIR "/cases/compare/bit-b-free.toml";
constexpr double rate = 15.0 / 3600.0;

CompareCase a_case(const std::vector<std::string>& overrides) {
  return read_compare_case(bit_b_free, overrides);
}

FreeString bare(const CompareCase& c) { return free_string(c, StringTerms::springs, "Langeveld"); }

/// The same bit, lowered at a rate.
CompareCase lowered_case(const std::vector<std::string>& more) {
  std::vector<std::string> all{"motion.kind='drilling'", "string.axial_stiffness='7e5 N/m'",
                               "string.torsional_stiffness='1e5 N m/rad'",
                               "string.axial_damping='5e5 N s/m'"};
  all.insert(all.end(), more.begin(), more.end());
  return read_compare_case(TDBD_SOURCE_DIR "/cases/compare/bit-b.toml", all);
}

std::string refused(const CompareCase& c) {
  try {
    bare(c);
  } catch (const InputError& e) {
    return e.what();
  }
  return "none";
}

/// Dampers that end at a moving top push with c V besides; 1e-5 of the load for a centimetre.
TEST(FreeString, a_load_is_the_force_of_a_soft_spring) {
  const FreeString s = bare(a_case({"string.dampers_to='space'"}));
  EXPECT_NEAR(s.axial_stiffness * s.top_z, 16e3, 1e-9);
  EXPECT_NEAR(s.axial_stiffness * 0.01, 16e3 * 1e-5, 1e-12);
  EXPECT_EQ(s.rate, 0.0);
  const FreeString to_top = bare(a_case({}));
  EXPECT_NEAR(to_top.axial_stiffness * to_top.top_z, 16e3 + 5e5 * rate, 1e-9);
}

TEST(FreeString, a_lowered_top_starts_with_the_weight_of_the_case) {
  const FreeString s =
      bare(lowered_case({"motion.weight_at_start='16 kN'", "string.dampers_to='space'"}));
  EXPECT_NEAR(s.axial_stiffness * (s.top_z - s.z), 16e3, 1e-9);
  EXPECT_NEAR(s.rate, rate, 1e-15);
}

TEST(FreeString, has_the_dampers_that_the_model_has) {
  const CompareCase c = a_case({});
  const FreeString all = free_string(c, StringTerms::springs_and_dampers, "Hanson and Hansen");
  EXPECT_EQ(all.lateral_damping, 2e5);
  EXPECT_EQ(all.twist_damping, 500.0);
  EXPECT_EQ(bare(c).lateral_damping, 0.0);
  EXPECT_NEAR((all.top_angle - bare(c).top_angle) * all.twist_stiffness, 500.0 * all.speed, 1e-9);
  EXPECT_NE(left_out(c, StringTerms::springs).find("lateral damping"), std::string::npos);
  EXPECT_EQ(left_out(c, StringTerms::springs_and_dampers).find("damping"), std::string::npos);
}

TEST(FreeString, rejects_an_unsupported_string_and_names_it) {
  for (const auto& [override, reason] : std::vector<std::pair<std::string, std::string>>{
           {"string.torsional_stiffness=0", "torsional_stiffness"},
           {"motion.start=['1 mm', '0 mm', '0 mm']", "beside the hole's axis"},
           {"rock.shape='flat'", "conforming"}}) {
    std::vector<std::string> overrides{override};
    if (override.starts_with("string")) overrides.emplace_back("motion.torque_at_start=0");
    if (override.starts_with("rock")) overrides.emplace_back("rock.radius='118 mm'");
    const std::string why = refused(a_case(overrides));
    EXPECT_EQ(why.find("Langeveld: found"), 0) << why;
    EXPECT_NE(why.find(reason), std::string::npos) << why;
  }
  const std::string slack = refused(lowered_case({"string.axial_stiffness=0"}));
  EXPECT_NE(slack.find("axial_stiffness = 0"), std::string::npos) << slack;
}

}  // namespace tdbd::reference::free_run_test

/// Hanson and Hansen's cones on the string of the shipped case. What the model itself must satisfy (oscillators, a bit at
/// rest, the balance of energy) is tested with the model (hanson_hansen_cones_test).
namespace tdbd::reference::free_cones_test {

constexpr double load = 40e3, damping = 2e4;  // N, N s/m, of the case

CompareCase free_bit_r(const std::vector<std::string>& more = {}) {
  std::vector<std::string> overrides{"time.duration='2 s'", "compare.spokes.spokes=40",
                                     "compare.spokes.spacing='2 mm'"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return model_runs::compare_case("bit-r-free", overrides);
}

const Findings& free_cones() {
  static const Findings f = model_runs::run(free_bit_r(), "hanson-hansen", load);
  return f;
}

/// The rest is what the momentum of the bit changes from the first to the last step that counts; seen: 4 N.
TEST(FreeCones, rock_carries_the_load_of_the_string) {
  const Findings& f = free_cones();
  constexpr double bounce = 12.0;  // N
  const double rate = model_runs::value(f, Quantity::rate_of_penetration);
  EXPECT_GT(rate, 0.0);
  EXPECT_NEAR(model_runs::value(f, Quantity::weight), load - damping * rate, bounce);
  EXPECT_EQ(model_runs::value(f, Quantity::rate_at_weight), rate);
}

TEST(FreeCones, have_the_loads_of_teeth_rows_and_cones_that_the_bit_carries) {
  const Findings& f = free_cones();
  for (const PartLevel level : {PartLevel::tooth, PartLevel::row, PartLevel::cone})
    EXPECT_NEAR(model_runs::sum_of_parts(f, PartQuantity::weight, level) /
                    model_runs::value(f, Quantity::weight),
                1.0, 1e-12);
  EXPECT_GT(model_runs::value(f, Quantity::whirl_radius), 0.0);
  for (const double ratio :
       model_runs::of_parts(f, PartQuantity::cone_speed_ratio, PartLevel::cone))
    EXPECT_NEAR(ratio, 1.47, 0.1);  // 1.37 to 1.6: between those at which single rows roll
}

/// Four steps of the model in one of 0.1 ms of the case: the same run.
TEST(FreeCones, take_short_steps_whatever_those_of_the_case) {
  const std::vector<std::string> brief{"time.duration='0.2 s'", "compare.counted_revolutions=0.1"};
  std::vector<std::string> fine = brief, coarse = brief;
  fine.emplace_back("time.step='0.025 ms'");
  coarse.emplace_back("time.step='0.1 ms'");
  const Findings a = model_runs::run(free_bit_r(fine), "hanson-hansen", load),
                 b = model_runs::run(free_bit_r(coarse), "hanson-hansen", load);
  EXPECT_NEAR(a.series.step, 0.025e-3, 1e-18);
  EXPECT_NEAR(b.series.step, 0.025e-3, 1e-18);
  EXPECT_NEAR(model_runs::value(a, Quantity::weight) / model_runs::value(b, Quantity::weight), 1.0,
              1e-3);
}

/// A tenth of the whirl on ten times the stiffness, as the side force is about the same; seen: 0.12.
TEST(FreeCones, a_stiffer_string_keeps_the_bit_nearer_to_the_axis) {
  const std::vector<std::string> brief{"compare.counted_revolutions=1", "time.duration='1 s'",
                                       "string.lateral_stiffness='1e8 N/m'"};
  const Findings stiff = model_runs::run(free_bit_r(brief), "hanson-hansen", load);
  EXPECT_LT(model_runs::value(stiff, Quantity::whirl_radius),
            0.3 * model_runs::value(free_cones(), Quantity::whirl_radius));
}

TEST(FreeCones, reject_a_string_that_lets_the_bit_out_of_its_rock) {
  const std::string why = model_runs::refusal(
      free_bit_r({"string.lateral_stiffness='1e3 N/m'", "string.lateral_damping='1 N s/m'"}),
      "hanson-hansen", load);
  EXPECT_EQ(why.find("Hanson and Hansen: found a bit "), 0u) << why;
  EXPECT_NE(why.find("where its rock ends; needs a stiffer string"), std::string::npos) << why;
}

TEST(FreeCones, are_those_of_one_model_alone) {
  const CompareCase c = free_bit_r();
  for (const auto& [name, title] :
       {std::pair("ma-azar", "Ma and Azar"), std::pair("ma-zhou-deng", "Ma, Zhou and Deng"),
        std::pair("sheppard-lesage", "Sheppard and Lesage"), std::pair("briggs", "Briggs")})
    EXPECT_EQ(model_runs::refusal(c, name, load),
              std::string(title) +
                  ": found motion.kind = \"drilling\", needs a bit whose motion is given");
}

}  // namespace tdbd::reference::free_cones_test
