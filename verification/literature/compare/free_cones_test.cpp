#include <gtest/gtest.h>

#include <cmath>

#include "verification/literature/compare/asked_models.hpp"

/// Hanson and Hansen's cones on the string of the shipped case. What the model itself must satisfy (oscillators, a bit at
/// rest, the balance of energy) is tested with the model (hanson_hansen_cones_test).
namespace tdbd::reference::free_cones_test {
namespace {

constexpr double load = 40e3, damping = 2e4;  // N, N s/m, of the case

CompareCase free_bit_r(const std::vector<std::string>& more = {}) {
  std::vector<std::string> overrides{"time.duration='2 s'", "compare.spokes.spokes=40",
                                     "compare.spokes.spacing='2 mm'"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return asked::compare_case("bit-r-free", overrides);
}

const Findings& free_cones() {
  static const Findings f = asked::ask(free_bit_r(), "hanson-hansen", load);
  return f;
}

/// The rest is what the momentum of the bit changes from the first to the last step that counts; seen: 4 N.
TEST(FreeCones, rock_carries_the_load_of_the_string) {
  const Findings& f = free_cones();
  constexpr double bounce = 12.0;  // N
  const double rate = asked::value(f, Quantity::rate_of_penetration);
  EXPECT_GT(rate, 0.0);
  EXPECT_NEAR(asked::value(f, Quantity::weight), load - damping * rate, bounce);
  EXPECT_EQ(asked::value(f, Quantity::rate_at_weight), rate);
}

TEST(FreeCones, say_of_teeth_rows_and_cones_what_the_bit_carries) {
  const Findings& f = free_cones();
  for (const PartLevel level : {PartLevel::tooth, PartLevel::row, PartLevel::cone})
    EXPECT_NEAR(
        asked::sum_of_parts(f, PartQuantity::weight, level) / asked::value(f, Quantity::weight),
        1.0, 1e-12);
  EXPECT_GT(asked::value(f, Quantity::whirl_radius), 0.0);
  for (const double ratio : asked::of_parts(f, PartQuantity::cone_speed_ratio, PartLevel::cone))
    EXPECT_NEAR(ratio, 1.47, 0.1);  // 1.37 to 1.6: between those at which single rows roll
}

/// Four steps of the model in one of 0.1 ms of the case: the same run.
TEST(FreeCones, take_short_steps_whatever_those_of_the_case) {
  const std::vector<std::string> brief{"time.duration='0.2 s'", "compare.counted_revolutions=0.1"};
  std::vector<std::string> fine = brief, coarse = brief;
  fine.emplace_back("time.step='0.025 ms'");
  coarse.emplace_back("time.step='0.1 ms'");
  const Findings a = asked::ask(free_bit_r(fine), "hanson-hansen", load),
                 b = asked::ask(free_bit_r(coarse), "hanson-hansen", load);
  EXPECT_NEAR(a.series.step, 0.025e-3, 1e-18);
  EXPECT_NEAR(b.series.step, 0.025e-3, 1e-18);
  EXPECT_NEAR(asked::value(a, Quantity::weight) / asked::value(b, Quantity::weight), 1.0, 1e-3);
}

/// A tenth of the whirl on ten times the stiffness, as the side force is about the same; seen: 0.12.
TEST(FreeCones, a_stiffer_string_keeps_the_bit_nearer_to_the_axis) {
  const std::vector<std::string> brief{"compare.counted_revolutions=1", "time.duration='1 s'",
                                       "string.lateral_stiffness='1e8 N/m'"};
  const Findings stiff = asked::ask(free_bit_r(brief), "hanson-hansen", load);
  EXPECT_LT(asked::value(stiff, Quantity::whirl_radius),
            0.3 * asked::value(free_cones(), Quantity::whirl_radius));
}

TEST(FreeCones, refuse_a_string_that_lets_the_bit_out_of_its_rock) {
  const std::string why = asked::refusal(
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
    EXPECT_EQ(asked::refusal(c, name, load),
              std::string(title) +
                  ": found motion.kind = \"drilling\", needs a bit whose motion is given");
}

}  // namespace
}  // namespace tdbd::reference::free_cones_test
