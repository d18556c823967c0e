#include <algorithm>
#include <array>
#include <cmath>

#include "claims/example_bits.hpp"
#include "core/types.hpp"
#include "reference/literature/roller/wheel/briggs_bit.hpp"
#include "reference/literature/roller/wheel/winters.hpp"

/// Chapter 2, on Winters, Warren and Onyia: rate from strength, strength from rate.
namespace tdbd::claims::strength_from_rate_test {

namespace ref = reference;

const std::string claim = "chapter2/strength-from-rate";
constexpr double rotary_speed = 3.0 * pi;                             // rad/s
constexpr double diameter = 0.2159;                                   // m
constexpr double friction_angle = 23.8 * degree, cohesion = 24.82e6;  // of Mancos shale, Pa

/// The rates that stand for measured ones: of the sprocket bit, which knows nothing of Winters.
ref::WintersPoint drilled(double weight, double strength_factor) {
  const ref::BriggsBit bit{{60e-3, 12, 30.0 * degree, 10e-3}, 3, 70e-3};
  const ref::CoulombRock rock{strength_factor * cohesion, friction_angle};
  const ref::BriggsDrilling d = ref::briggs_under_weight(bit, rock, weight, rotary_speed);
  return {{weight, diameter, rotary_speed}, ref::wedge_pressure(rock, 0.0), d.rate};
}

TEST(StrengthFromRate, is_undone_by_rate_from_strength) {
  const ref::WintersConstants k{.ductility = 0.0324, .offset = 0.96, .teeth = 19.0};
  double worst = 0.0;
  for (const double weight : {20e3, 80e3, 320e3})
    for (const double strength : {20e6, 100e6, 400e6}) {
      const ref::WintersRun run{weight, diameter, rotary_speed};
      const double rate = ref::winters_rate(k, run, strength);
      worst = std::max(worst, std::abs(ref::winters_strength(k, run, rate) / strength - 1.0));
    }
  record_bound(claim, "strength from rate from strength, nine runs: largest relative error", worst,
               "1", 1e-12);
}

/// Three rates fix the constants; a fourth and another rock are predicted. The fitted b is negative: a
/// sprocket in plastic rock has no limit of cleaning, so the form does not hold exactly.
TEST(StrengthFromRate, predicts_a_withheld_bit_within_a_fifth) {
  const ref::WintersFit fit =
      ref::fit_winters({drilled(2e3, 1.0), drilled(4e3, 1.0), drilled(8e3, 1.0)});
  const ref::WintersPoint next = drilled(16e3, 1.0);
  const std::string of = "fitted to rates of the sprocket bit at 2, 4 and 8 kN: ";
  record_bound(
      claim, of + "rate at 16 kN over the bit's, distance from 1",
      std::abs(ref::winters_rate(fit.constants, next.run, next.strength) / next.rate - 1.0), "1",
      0.2);
  double inside = 0.0;
  for (const double weight : {4e3, 8e3}) {
    const ref::WintersPoint other = drilled(weight, 1.5);
    const double found = ref::winters_strength(fit.constants, other.run, other.rate);
    inside = std::max(inside, std::abs(found / other.strength - 1.0));
  }
  record_bound(claim,
               of + "strength of a rock 1.5 times as strong from its rates at 4 and 8 kN, error",
               inside, "1", 0.013);
  const ref::WintersPoint light = drilled(1e3, 1.5);
  record_bound(
      claim, of + "strength of that rock from its rate at 1 kN, below the fit, error",
      std::abs(ref::winters_strength(fit.constants, light.run, light.rate) / light.strength - 1.0),
      "1", 0.15);
  EXPECT_LT(fit.constants.teeth, 0.0);
}

}  // namespace tdbd::claims::strength_from_rate_test
