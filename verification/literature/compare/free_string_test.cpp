#include "reference/compare/models/free_string.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace tdbd::reference::free_string_test {
namespace {

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

TEST(FreeString, refuses_what_such_a_model_cannot_hold_by_its_name) {
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

}  // namespace
}  // namespace tdbd::reference::free_string_test
