#pragma once

#include <string>
#include <vector>

#include "bit/cutter/cutter_table.hpp"
#include "reference/literature/drag/wear/glowka_metres.hpp"

/// Bits and laws that tests of Glowka's model share.
namespace tdbd::reference::glowka_laws {

inline constexpr double inch = 25.4e-3, lbf = 4.4482216152605;  // m, N

/// Power fits to single-cutter tests of Sandia's kind, 20 degrees of back rake: a sharp cutter of
/// 3/4 in in Berea sandstone; sharp of 1/2 in, and blunt of 3/4 in (0.02 in2), in Sierra White granite.
inline const GlowkaLaw sharp_in_berea{.normal = {3537.0 * lbf, inch, 1.36},
                                      .drag = {5281.0 * lbf, inch, 1.40}};
inline const GlowkaLaw in_granite{.normal = {25473.0 * lbf, inch, 1.64},
                                  .drag = {47713.0 * lbf, inch, 1.88},
                                  .flat_stress = {2067.0 / 0.02 * lbf / (inch * inch), inch, 0.33},
                                  .flat_friction = 0.7};

/// Made up, of the order of granite and of a cutter in water.
inline const FlatHeat granite_heat{.friction = 0.15,
                                   .rock_conductivity = 3.5,
                                   .rock_diffusivity = 1.5e-6,
                                   .cutter_resistance = 0.3e-4};

inline std::vector<bit::Cutter> cutters_of(const std::string& bit) {
  return bit::read_cutter_table(TDBD_SOURCE_DIR "/cases/bits/" + bit + ".csv",
                                bit::CutterDefaults{});
}

inline GlowkaLoads loads_of(const GlowkaBit& bit, const GlowkaLaw& law,
                            const std::vector<double>& worn, const GlowkaRun& run) {
  GlowkaLoads loads;
  glowka_loads(bit, law, granite_heat, worn, run, loads);
  return loads;
}

}  // namespace tdbd::reference::glowka_laws
