#include "reference/compare/comparison.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <sstream>

#include "core/error.hpp"
#include "literature/compare/model_runs.hpp"
#include "reference/compare/compare_case.hpp"
#include "reference/compare/comparison_files.hpp"
#include "reference/compare/findings.hpp"
#include "reference/compare/model.hpp"

namespace tdbd::reference::comparison_test {

/// Bit B on a coarse rock: quick, and every model speaks.
CompareCase coarse_case() {
  return read_compare_case(TDBD_SOURCE_DIR "/cases/compare/bit-b.toml",
                           {"rock.edge_length='3 mm'", "time.step='4 ms'", "time.revolutions=2"});
}

const Comparison& coarse() {
  static const Comparison all = [] {
    const CompareCase c = coarse_case();
    return compare(c, chosen_models(c, {"all"}), Refusal::stops, {});
  }();
  return all;
}

TEST(Comparison, every_blank_has_a_reason_and_every_number_none) {
  for (const Answer& a : coarse().answers)
    for (std::size_t i = 0; i < quantity_count; ++i) {
      const QuantityResult& s = a.findings.says[i];
      EXPECT_NE(s.value.has_value(), !s.reason.empty())
          << a.model->name << ": " << quantity_texts()[i].name;
    }
}

TEST(Comparison, takes_its_reference_weight_from_the_first_model_with_one) {
  EXPECT_EQ(coarse().weight_from, "TDBD");
  EXPECT_EQ(coarse().weight, *saying(coarse().answers.front().findings, Quantity::weight).value);
}

TEST(Comparison, csv_has_a_row_for_every_model_and_quantity) {
  std::istringstream text(comparison_csv(coarse()));
  std::string line;
  std::size_t lines = 0;
  while (std::getline(text, line)) ++lines;
  EXPECT_EQ(lines, 1 + coarse().answers.size() * quantity_count);
}

/// Areas of cutters times their circles are their volumes, except beside the axis.
TEST(Comparison, areas_of_cutters_agree_with_what_they_remove) {
  const Answer& ours = coarse().answers.front();
  double sum = 0.0;
  for (const PartFinding& p : ours.findings.parts)
    if (p.quantity == PartQuantity::volume_per_revolution) sum += p.value;
  EXPECT_NEAR(sum, *saying(ours.findings, Quantity::removed_per_revolution).value, 1e-12 * sum);
}

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

TEST(CompareCase, rejects_what_cannot_be_compared) {
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

TEST(CompareCase, rejects_models_that_do_not_support_the_bit_by_their_name) {
  const std::string unknown = refusal({}, "warren");
  EXPECT_NE(unknown.find("found 'warren'"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("tdbd"), std::string::npos) << unknown;
}

TEST(Findings, names_of_quantities_are_all_different) {
  std::set<std::string_view> names;
  for (const QuantityText& q : quantity_texts()) names.insert(q.name);
  EXPECT_EQ(names.size(), quantity_count);
  EXPECT_EQ(text_of(Quantity::hottest_flat).name, "hottest_flat");
  EXPECT_EQ(text_of(PartQuantity::teeth_in_contact).name, "teeth_in_contact");
}

TEST(Findings, levels_of_parts_are_read_from_their_names) {
  const auto level = [](const char* name) {
    return level_of({name, 0.0, PartQuantity::weight, 0.0});
  };
  EXPECT_EQ(level("cutter-12"), PartLevel::cutter);
  EXPECT_EQ(level("cone-1"), PartLevel::cone);
  EXPECT_EQ(level("cone-1/row-2"), PartLevel::row);
  EXPECT_EQ(level("cone-1/row-2/tooth-3"), PartLevel::tooth);
}

TEST(Findings, a_number_that_is_not_finite_is_a_blank_with_its_reason) {
  Findings f;
  say(f, Quantity::weight, std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(saying(f, Quantity::weight).value);
  EXPECT_EQ(saying(f, Quantity::weight).reason, "its number is not finite");
}

TEST(Findings, a_reason_never_replaces_a_number_or_an_earlier_reason) {
  Findings f;
  say(f, Quantity::weight, 1.0);
  set_missing(f, Quantity::torque, "first");
  set_missing(f, {Quantity::weight, Quantity::torque, Quantity::imbalance}, "second");
  EXPECT_EQ(saying(f, Quantity::weight).value, 1.0);
  EXPECT_EQ(saying(f, Quantity::torque).reason, "first");
  EXPECT_EQ(saying(f, Quantity::imbalance).reason, "second");
}

/// A sine of amplitude a about 1 has the rms deviation a / sqrt 2; averaged over n of N steps a
/// period, sin(pi n/N) / (n sin(pi/N)) of it is left.
TEST(Findings, noise_of_a_sine_is_its_rms_and_averages_as_sines_do) {
  constexpr std::size_t period = 20, together = 5;
  std::vector<double> values;
  for (std::size_t i = 0; i < 50 * period; ++i)
    values.push_back(
        1.0 + 0.3 * std::sin(2.0 * std::numbers::pi * (static_cast<double>(i) + 0.37) / period));
  const double rms = 0.3 / std::numbers::sqrt2;
  EXPECT_NEAR(noise_of(values, 1).mean, 1.0, 1e-13);
  EXPECT_NEAR(noise_of(values, 1).share, rms, 1e-13);
  const double x = std::numbers::pi / period;
  EXPECT_NEAR(noise_of(values, together).share,
              rms * std::sin(together * x) / (together * std::sin(x)), 1e-13);
}

TEST(Findings, noise_of_nothing_is_nothing) {
  EXPECT_EQ(noise_of({}, 1).share, 0.0);
  EXPECT_EQ(noise_of({1.0}, 2).share, 0.0);
}

TEST(Findings, the_work_of_a_turn_adds_what_the_weight_does) {
  Findings f;
  set_steady_load_quantities(f, 2.0e4, 1.2e3, 2e-3);
  EXPECT_NEAR(*saying(f, Quantity::work_of_a_turn_torque).value,
              1.2e3 + 2.0e4 * 2e-3 / (2.0 * std::numbers::pi), 1e-12);
  EXPECT_FALSE(saying(f, Quantity::torque_noise).value);
}

TEST(Findings, steps_longer_than_5_ms_have_no_mean_over_5_ms) {
  Findings f;
  set_load_quantities(f, {0.02, {1.0, 2.0}, {3.0, 4.0}}, 1e-3);
  EXPECT_EQ(saying(f, Quantity::torque_noise_5ms).reason, "its step is longer than 5 ms");
  EXPECT_EQ(*saying(f, Quantity::torque).value, 3.5);
}

}  // namespace tdbd::reference::comparison_test

/// What the comparison reads off our own run, against what steady drilling must give.
namespace tdbd::reference::tdbd_model_test {

constexpr double reach = 107.95e-3, eps = 100e6;  // m, Pa

/// Two revolutions count, so that what belongs to one is not what belongs to all.
CompareCase two_counted() {
  return model_runs::compare_case(
      "bit-b", {"rock.edge_length='2 mm'", "time.step='2 ms'", "compare.counted_revolutions=2"});
}

const Findings& ours() {
  static const Findings f = model_runs::run(two_counted(), "tdbd", 0.0);
  return f;
}

std::map<std::string, double> numbers_of(const Findings& f, PartQuantity q) {
  std::map<std::string, double> numbers;
  for (const PartFinding& p : f.parts)
    if (p.quantity == q) numbers[p.part] = p.value;
  return numbers;
}

TEST(TdbdModel, returns_the_volumes_of_one_revolution) {
  const double disc = std::numbers::pi * reach * reach * two_counted().advance;
  EXPECT_NEAR(model_runs::value(ours(), Quantity::removed_per_revolution), disc, 1.2e-3 * disc);
  double sum = 0.0;
  for (const auto& [part, volume] : numbers_of(ours(), PartQuantity::volume_per_revolution))
    sum += volume;
  EXPECT_NEAR(sum, disc, 1.2e-3 * disc);
}

/// A sharp face drags eps times its area normal to the helix; seen along the circle the area is larger
/// by 1/cos of the helix's angle, less than 1e-3 beyond 10 mm. The tip stands for the face, where the helix is a little steeper.
TEST(TdbdModel, returns_the_areas_of_its_drag) {
  const auto drags = numbers_of(ours(), PartQuantity::drag);
  int cutters = 0;
  for (const PartFinding& p : ours().parts)
    if (p.quantity == PartQuantity::area && p.radius > 10e-3) {
      const double helix = two_counted().advance / (2 * std::numbers::pi * p.radius);
      EXPECT_NEAR(p.value * eps / drags.at(p.part), std::hypot(1.0, helix), 1.3e-6) << p.part;
      ++cutters;
    }
  EXPECT_EQ(cutters, 27);
}

TEST(TdbdModel, moves_no_cutter_backwards_in_steady_drilling) {
  EXPECT_EQ(model_runs::value(ours(), Quantity::share_moved_backwards), 0.0);
}

/// Behr's planes cut the same bottom; at 100 mm it falls by 1.5 mm a millimetre of radius.
TEST(TdbdModel, shows_the_bottom_on_the_requested_circle) {
  const Findings planes = model_runs::run(two_counted(), "behr", 0.0);
  const auto mean = [](const BottomCircle& c) {
    return std::accumulate(c.depth.begin(), c.depth.end(), 0.0) /
           static_cast<double>(c.depth.size());
  };
  ASSERT_TRUE(ours().bottom && planes.bottom);
  EXPECT_NEAR(mean(*ours().bottom), mean(*planes.bottom), 0.2e-3);
}

/// The drag of a led bit's cutter, too, is eps times its area, against its turning.
TEST(TdbdModel, has_the_drag_of_led_bits) {
  const Findings led = model_runs::run(two_counted(), "langeveld", 0.0);
  const auto drags = numbers_of(led, PartQuantity::drag);
  for (const auto& [part, area] : numbers_of(led, PartQuantity::area))
    EXPECT_NEAR(drags.at(part), eps * area, 2e-3 * eps * area) << part;
}

}  // namespace tdbd::reference::tdbd_model_test
