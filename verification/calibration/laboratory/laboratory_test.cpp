#include "calibration/laboratory/laboratory.hpp"

#include <gtest/gtest.h>

#include "calibration/made_up_laboratory.hpp"
#include "core/error.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::calibration::laboratory_test {
namespace {

LaboratoryCase laboratory(const Noise& noise, std::uint64_t seed = 1) {
  LaboratoryCase c{made_up_case(), seed};
  c.setup.law = hidden_law();
  c.setup.noise = noise;
  return c;
}

/// Logarithms of the loads over those of a laboratory without noise.
std::vector<std::array<double, 2>> errors(const LaboratoryCase& c) {
  const CutStore cuts = made_up_cuts(c.setup);
  const auto noisy = drill(c, cuts), true_ones = drill(laboratory({.reading = 0.0}), cuts);
  std::vector<std::array<double, 2>> all;
  for (std::size_t i = 0; i < noisy.size(); ++i)
    all.push_back(
        {std::log(*noisy[i].readings[axial].value / *true_ones[i].readings[axial].value),
         std::log(*noisy[i].readings[turning].value / *true_ones[i].readings[turning].value)});
  return all;
}

TEST(Laboratory, the_same_seed_gives_the_same_records) {
  const CutStore cuts = made_up_cuts(made_up_case());
  const Noise noise{.reading = 0.03, .test = 0.03, .rop = 0.02};
  const std::string records = records_csv(drill(laboratory(noise, 7), cuts));
  EXPECT_EQ(records, records_csv(drill(laboratory(noise, 7), cuts)));
  EXPECT_NE(records, records_csv(drill(laboratory(noise, 8), cuts)));
}

/// Four records of two loads make a test; 1e-14 is rounding of logarithms.
TEST(Laboratory, a_factor_is_common_to_a_test) {
  const auto e = errors(laboratory({.reading = 0.0, .test = 0.05}));
  for (std::size_t i = 0; i < e.size(); ++i)
    for (const double one : e[i]) EXPECT_NEAR(one, e[4 * (i / 4)][axial], 1e-14);
  EXPECT_GT(std::abs(e[0][axial] - e[4][axial]), 1e-3);
}

TEST(Laboratory, an_error_of_the_rate_moves_both_loads_by_their_slopes) {
  const LaboratoryCase c = laboratory({.reading = 0.0, .rop = 0.02});
  const auto e = errors(c);
  for (std::size_t i = 0; i < e.size(); ++i) {
    const Record& r = c.setup.records.rows[i];
    const Sample s = sample_of(cut_run_of(made_up_cuts(c.setup), r), r,
                               strength_of(c.setup.rock, r), c.setup.law);
    const Loads slopes = depth_slopes(c.setup.law, s);
    EXPECT_NEAR(e[i][axial] / slopes[axial], e[i][turning] / slopes[turning], 1e-13);
  }
}

/// 2400 numbers determine a deviation to 1.4 %.
TEST(Laboratory, readings_scatter_as_they_should) {
  double squares = 0.0, sum = 0.0, count = 0.0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
    for (const auto& both : errors(laboratory({.reading = 0.03}, seed)))
      for (const double e : both) {
        squares += e * e;
        sum += e;
        count += 1.0;
      }
  EXPECT_EQ(count, 2400.0);
  EXPECT_NEAR(std::sqrt(squares / count), 0.03, 0.0011);
  EXPECT_NEAR(sum / count, 0.0, 0.0014);
}

TEST(Laboratory, its_records_are_read_as_they_were_drilled) {
  const auto drilled = drill(laboratory({.reading = 0.03}), made_up_cuts(made_up_case()));
  const std::string path = temporary_folder() + "lab.csv";
  std::ofstream(path) << records_csv(drilled);
  const Records read = read_records(path);
  ASSERT_EQ(read.rows.size(), drilled.size());
  for (std::size_t i = 0; i < drilled.size(); ++i) {
    EXPECT_EQ(read.rows[i].test, drilled[i].test);
    EXPECT_EQ(read.rows[i].rate, drilled[i].rate);
    EXPECT_EQ(*read.rows[i].readings[turning].value, *drilled[i].readings[turning].value);
  }
}

/// Some of the bits may be chosen; an unknown bit is rejected.
TEST(Laboratory, drills_with_the_bits_of_the_case) {
  const std::string path = TDBD_SOURCE_DIR "/validation/blind/hidden-hanson-hansen.toml";
  const std::vector<std::string> all = read_laboratory(path, {}).setup.fit;
  ASSERT_GT(all.size(), 1U);
  const std::string one = "laboratory.bits=[\"" + all[0] + "\"]";
  EXPECT_EQ(read_laboratory(path, {one}).setup.fit, std::vector{all[0]});
  try {
    read_laboratory(path, {"laboratory.bits=[\"" + all[0] + "\", \"nobody\"]"});
    FAIL() << "accepted";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("'nobody'"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace tdbd::calibration::laboratory_test
