#include "reference/compare/compare_case.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "reference/compare/model.hpp"

namespace tdbd::reference::compare_case_test {
namespace {

const std::string bit_b = TDBD_SOURCE_DIR "/cases/compare/bit-b.toml";

std::string mistake(const std::vector<std::string>& overrides) {
  try {
    read_compare_case(bit_b, overrides);
  } catch (const InputError& e) {
    return e.what();
  }
  return "none";
}

/// Why models cannot be chosen.
std::string refusal(const std::vector<std::string>& overrides, const std::string& name) {
  const CompareCase c = read_compare_case(bit_b, overrides);
  try {
    chosen_models(c, {name});
  } catch (const InputError& e) {
    return e.what();
  }
  return "none";
}

TEST(CompareCase, has_the_advance_of_a_turn_and_the_rock_of_the_faces) {
  const CompareCase c = read_compare_case(bit_b, {});
  EXPECT_NEAR(c.advance, 15.0 / 3600 / 2, 1e-15);
  ASSERT_TRUE(c.rock);
  EXPECT_EQ(c.rock->specific_energy, 100e6);
  EXPECT_EQ(c.rock->normal_ratio, 0.8);
  EXPECT_EQ(counted_steps(c), 500);
}

TEST(CompareCase, refuses_what_cannot_be_compared) {
  EXPECT_NE(mistake({"compare.circle='2 m'"}).find("compare.circle"), std::string::npos);
  EXPECT_NE(mistake({"compare.counted_revolutions=30"}).find("counted_revolutions"),
            std::string::npos);
  EXPECT_NE(mistake({"compare.modles=['tdbd']"}).find("compare.modles"), std::string::npos);
  EXPECT_NE(mistake({"motion.rate_of_penetration=0"}).find("does not advance"), std::string::npos);
  EXPECT_NE(mistake({"rock.edge_length='-1 mm'"}).find("rock.edge_length"), std::string::npos);
  EXPECT_NE(
      mistake({"forces.areas.soft={kind='face', law='none'}"})
          .find("found laws by area ([forces.areas]), expected one law for each kind of part"),
      std::string::npos);
}

/// A bit on a string: its weight is the reference weight, and is given once.
TEST(CompareCase, takes_the_reference_weight_of_a_string_from_its_motion) {
  const std::string on_string = TDBD_SOURCE_DIR "/cases/compare/bit-b-free.toml";
  const CompareCase c = read_compare_case(on_string, {});
  EXPECT_TRUE(is_free(c));
  EXPECT_EQ(c.options.weight_on_bit, 16e3);
  EXPECT_THROW(read_compare_case(on_string, {"compare.weight_on_bit='10 kN'"}), InputError);
  EXPECT_THROW(read_compare_case(on_string, {"motion.rotary_speed=0"}), InputError);
  try {
    chosen_models(c, {"glowka"});
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()).find("Glowka: found motion.kind"), 0) << e.what();
  }
}

TEST(CompareCase, refuses_models_that_do_not_know_the_bit_by_their_name) {
  const std::string unknown = refusal({}, "warren");
  EXPECT_NE(unknown.find("found 'warren'"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("tdbd"), std::string::npos) << unknown;
}

}  // namespace
}  // namespace tdbd::reference::compare_case_test
