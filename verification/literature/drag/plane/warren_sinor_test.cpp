#include "reference/literature/drag/plane/warren_sinor.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "battery/generators.hpp"
#include "bit/profile/bit_analysis.hpp"
#include "core/error.hpp"
#include "core/types.hpp"
#include "literature/drag/example_cutters.hpp"

namespace tdbd::reference::warren_sinor_test {
namespace {

constexpr double mm = 1e-3, mm2 = 1e-6;
constexpr double printed = 5e-4;  // relative: the tables' own accuracy

WarrenSinorOptions fine() { return {.column = 0.01 * mm, .normal_ratio = {}, .flat_area = {}}; }

struct Row {
  char bit;
  double advance;                        // mm
  double weight, torque;                 // N, N m
  double radial, circumferential, both;  // % of the weight
  double degrees;                        // of the imbalance; NaN: unstable
  double largest;                        // mm2
};

double largest_area(const WarrenSinorLoad& load) {
  double most = 0.0;
  for (const WarrenSinorCutter& c : load.cutters) most = std::max(most, c.area);
  return most;
}

void expect_row(const Row& row, const WarrenSinorLoad& load) {
  const auto percent = [&](const Eigen::Vector2d& f) { return 100 * f.norm() / load.weight; };
  constexpr double absolute = 0.05;  // % of the weight
  EXPECT_NEAR(load.weight, row.weight, printed * row.weight);
  EXPECT_NEAR(load.torque, row.torque, printed * row.torque);
  EXPECT_NEAR(percent(load.radial_B), row.radial, absolute);
  EXPECT_NEAR(percent(load.circumferential_B), row.circumferential, absolute);
  EXPECT_NEAR(100 * load.imbalance(), row.both, absolute);
  EXPECT_NEAR(largest_area(load), row.largest * mm2, printed * row.largest * mm2);
  if (std::isnan(row.degrees)) return;
  const Eigen::Vector2d f = load.imbalance_B();
  EXPECT_NEAR(std::atan2(f.y(), f.x()) / degree, row.degrees, 0.6);
}

/// The imbalance of bit A is small, and so its direction is that of the mesh's noise: it is never
/// tested.
TEST(WarrenSinor, has_the_loads_of_the_example_bits) {
  const double none = std::nan("");
  const std::vector<Row> rows{{'a', 1.0, 7609.5, 582.66, 1.07, 2.91, 2.42, none, 7.386},
                              {'a', 2.08333, 15838.3, 1213.88, 1.05, 1.86, 0.93, none, 15.451},
                              {'a', 3.0, 22779.2, 1747.98, 1.02, 1.60, 0.85, none, 22.374},
                              {'b', 2.08333, 15589.9, 1213.88, 1.42, 7.64, 7.93, -74.6, 18.363},
                              {'b', 3.0, 22414.8, 1747.98, 1.32, 7.64, 7.94, -75.0, 26.235},
                              {'c', 3.0, 22589.3, 1747.98, 0.96, 3.28, 2.54, -140, 18.451}};
  for (const Row& row : rows) {
    SCOPED_TRACE(std::string("bit ") + row.bit + " at " + std::to_string(row.advance) + " mm");
    expect_row(row, warren_sinor(example_cutters(row.bit), row.advance * mm, rock_k(), fine()));
  }
}

/// 500 columns instead of 10 795 move a tenth of a balanced bit's imbalance, and a hundredth of that
/// of bit B: models are compared on bit B.
TEST(WarrenSinor, has_an_uncertain_imbalance_for_balanced_bits) {
  const auto share = [](char bit, double columns) {
    const WarrenSinorOptions options{
        .column = example_gage / columns * 1.000001, .normal_ratio = {}, .flat_area = {}};
    return 100 * warren_sinor(example_cutters(bit), 3 * mm, rock_k(), options).imbalance();
  };
  EXPECT_NEAR(share('a', 10795), 0.845, 0.005);
  EXPECT_NEAR(share('a', 500), 0.75, 0.005);
  EXPECT_NEAR(share('b', 500) / share('b', 10795), 1.0, 0.01);
}

/// The core that turned outlines leave carries no weight, and moves the imbalance of a balanced
/// bit: 1.037 % of the weight where the plane has 0.845 %. Side rakes up to 3.7 degrees move 0.06 %
/// of the weight from the shoulder to its neighbours.
TEST(WarrenSinor, with_turned_outlines_has_a_core_that_carries_nothing) {
  WarrenSinorOptions turned = fine();
  turned.form = OutlineForm::turned;
  const auto cutters = example_cutters('a');
  const WarrenSinorLoad load = warren_sinor(without_side_rake(cutters), 3 * mm, rock_k(), turned);
  EXPECT_NEAR(load.weight, 22658.0, printed * 22658.0);
  EXPECT_NEAR(100 * load.imbalance(), 1.037, 0.05);
  const double raked = warren_sinor(cutters, 3 * mm, rock_k(), turned).weight;
  EXPECT_NEAR(raked / load.weight, 1.0 - 0.0006, 0.0001);
}

/// T = eps R^2 d/2 of sharp cutters, whatever the layout, if they leave no gap up to R.
RC_GTEST_PROP(WarrenSinor, has_the_torque_of_the_whole_disc_for_any_layout, ()) {
  const int count = *battery::integer(8, 20);
  const double spacing = 8 * mm, d = *battery::number(0.01, 10.0) * mm;
  std::vector<bit::Cutter> cutters(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < cutters.size(); ++i) {
    bit::Cutter& c = cutters[i];
    c.tip_radius = (static_cast<double>(i) + 0.5) * spacing;
    c.diameter = *battery::number(13.0, 19.0) * mm;
    c.tip_height = *battery::number(0.0, 30.0) * mm;
    c.azimuth = *battery::number(-7.0, 7.0);
    c.profile_angle = *battery::number(-0.3, 0.3);
    c.back_rake = *battery::number(0.0, 0.5);
  }
  const double eps = *battery::number(1.0, 500.0) * 1e6;
  const DragRock rock{eps, *battery::number(0.0, 2.0), 0.0, 0.0};
  const RadialOutlines outlines = radial_outlines(cutters, OutlineForm::planar, 0.1 * mm);
  const WarrenSinorLoad load =
      warren_sinor(cutters, d, rock, {.column = 0.1 * mm, .normal_ratio = {}, .flat_area = {}});
  const double R = outlines.reach, torque = eps * R * R * d / 2;
  RC_ASSERT(std::abs(load.torque / torque - 1.0) < 1e-8);
  RC_ASSERT(std::abs(load.volume / (std::numbers::pi * R * R * d) - 1.0) < 1e-8);
}

/// Found by weight, the advance is the one that gives that weight.
TEST(WarrenSinor, finds_the_rate_for_a_weight) {
  const auto cutters = example_cutters('b');
  const WarrenSinorLoad load = warren_sinor_at_weight(cutters, 20e3, rock_k());
  EXPECT_NEAR(load.weight, 20e3, 1e-9 * 20e3);
  EXPECT_DOUBLE_EQ(load.weight, warren_sinor(cutters, load.advance, rock_k()).weight);
  const WarrenSinorLoad known = warren_sinor(cutters, 2.08333 * mm, rock_k());
  const WarrenSinorLoad again = warren_sinor_at_weight(cutters, known.weight, rock_k());
  EXPECT_NEAR(again.advance, known.advance, 1e-9 * known.advance);
  EXPECT_NEAR(again.rate(4 * std::numbers::pi), 15.0 / 3600, 1e-5 * 15.0 / 3600);
}

RC_GTEST_PROP(WarrenSinor, carries_no_less_at_a_larger_advance, ()) {
  const auto cutters = example_cutters(*rc::gen::element('a', 'b', 'c'));
  const double d = *battery::number(0.01, 10.0) * mm, more = *battery::number(0.0, 5.0) * mm;
  RC_ASSERT(warren_sinor(cutters, d + more, rock_k()).weight >=
            warren_sinor(cutters, d, rock_k()).weight);
}

/// Flats of 10 mm2 at 60 MPa and mu = 0.5: each cutter that cuts presses with 600 N more.
TEST(WarrenSinor, adds_what_the_flats_carry) {
  const auto cutters = example_cutters('b');
  DragRock rock = rock_k();
  rock.contact_stress = 60e6;
  rock.friction = 0.5;
  WarrenSinorOptions worn;
  worn.flat_area.assign(cutters.size(), 10 * mm2);
  const WarrenSinorLoad sharp = warren_sinor(cutters, 2 * mm, rock),
                        load = warren_sinor(cutters, 2 * mm, rock, worn);
  double weight = sharp.weight, torque = sharp.torque;
  for (std::size_t i = 0; i < cutters.size(); ++i)
    if (sharp.cutters[i].area > 0.0) {
      weight += 600.0 * std::cos(cutters[i].profile_angle);
      torque += 300.0 * cutters[i].tip_radius;
    }
  EXPECT_NEAR(load.weight, weight, 1e-12 * weight);
  EXPECT_NEAR(load.torque, torque, 1e-12 * torque);
  EXPECT_GT(load.weight, sharp.weight);
}

std::string complaint(double weight, const std::vector<bit::Cutter>& cutters,
                      const WarrenSinorOptions& options = {}) {
  try {
    DragRock rock = rock_k();
    rock.contact_stress = 60e6;
    warren_sinor_at_weight(cutters, weight, rock, options);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(WarrenSinor, rejects_what_it_cannot_do) {
  const auto cutters = example_cutters('b');
  WarrenSinorOptions worn;
  worn.flat_area.assign(cutters.size(), 10 * mm2);
  EXPECT_EQ(complaint(1.0, {}),
            "Warren and Sinor: found a bit without cutters, expected at least one cutter");
  EXPECT_NE(complaint(1e9, cutters).find("found 1e+09 N, expected from"), std::string::npos);
  EXPECT_NE(complaint(1e3, cutters, worn).find("no advance from 1e-09"), std::string::npos);
  worn.flat_area.pop_back();
  EXPECT_NE(complaint(1e3, cutters, worn).find("areas of flats"), std::string::npos);
  EXPECT_THROW(warren_sinor(cutters, 0.0, rock_k()), InputError);
}

}  // namespace
/// The analysis before drilling has the model's imbalance in closed form.
TEST(WarrenSinor, imbalance_is_that_of_the_analysis_before_drilling) {
  constexpr double rounding = 1e-13;
  for (const char name : {'a', 'b', 'c'}) {
    const std::vector<bit::Cutter> cutters = example_cutters(name);
    for (const double ratio : {0.5, 0.8, 1.3}) {
      DragRock rock = rock_k();
      rock.normal_ratio = ratio;
      const WarrenSinorLoad load = warren_sinor(cutters, 3 * mm, rock, fine());
      std::vector<double> areas;
      for (const WarrenSinorCutter& c : load.cutters) areas.push_back(c.area);
      EXPECT_NEAR(bit::planar_imbalance(cutters, areas, ratio), load.imbalance(), rounding) << name;
    }
  }
}

}  // namespace tdbd::reference::warren_sinor_test
