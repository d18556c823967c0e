#include <algorithm>
#include <cmath>

#include "claims/example_bits.hpp"
#include "core/types.hpp"
#include "reference/literature/drag/wear/glowka_bit.hpp"

/// Chapter 2, on Glowka: laws of cutters in virgin rock, read at the effective depth.
namespace tdbd::claims::effective_depth_test {

/// A power of the depth and a force in proportion to the area, equal for a virgin cut of 1 mm: the
/// bit's weight by the first over that by the second.
double against_areas(const bit::Bit& bit, double power, double advance) {
  const reference::GlowkaBit glowka = reference::glowka_bit(bit.cutters);
  reference::GlowkaLaw law;
  law.normal = {.value = 1e3, .reference_depth = 1e-3, .power = power};
  reference::GlowkaLoads loads;
  reference::glowka_loads(glowka, law, {}, std::vector<double>(bit.cutters.size()),
                          {.advance = advance, .rotary_speed = 4.0 * pi}, loads);
  double by_area = 0.0;
  for (std::size_t i = 0; i < bit.cutters.size(); ++i) {
    const bit::Cutter& c = bit.cutters[i];
    const double virgin = reference::virgin_area(reference::glowka_face(c), 1e-3);
    by_area += 1e3 * loads.cutters[i].area / virgin * std::cos(c.profile_angle);
  }
  return loads.weight / by_area;
}

/// Segments of a disc grow nearly as the depth to 3/2, so a sharp cutter's law (powers near 3/2 in
/// Berea sandstone) is a law of areas in disguise; that of a blunt one (0.33 in granite) is not.
TEST(EffectiveDepth, is_a_law_of_areas_for_sharp_cutters_only) {
  const std::string claim = "chapter2/effective-depth";
  double sharp = 0.0, blunt = 1.0;
  for (const bit::Bit& bit : fixed_cutter_bits())
    for (const double advance : {1e-3, 2e-3, 3e-3}) {
      sharp = std::max(sharp, std::abs(against_areas(bit, 1.5, advance) - 1.0));
      blunt = std::min(blunt, against_areas(bit, 0.33, advance));
    }
  const std::string of =
      "weight of bits A to C, 1 to 3 mm a revolution, over that of a law of areas ";
  record_bound(claim, of + "that is equal at 1 mm: power 1.5, largest distance from 1", sharp, "1",
               0.03);
  EXPECT_NEAR(blunt, 0.423, 1.3e-4);
  battery::record({claim, of + "that is equal at 1 mm: power 0.33 of a blunt cutter, least", blunt,
                   "1", "< 0.5: the two laws part",
                   blunt < 0.5 ? battery::Verdict::holds_with_limits : battery::Verdict::refuted});
}

}  // namespace tdbd::claims::effective_depth_test
