#pragma once

#include <optional>

#include "reference/literature/drag/wear/glowka_bit.hpp"

namespace tdbd::reference {

/// Options of a run of wear over drilled metres.
struct GlowkaWearOptions {
  double distance = 0.0;           ///< m, to drill
  int records = 10;                ///< number, at equal distances, besides that of the start
  double height_tolerance = 1e-6;  ///< m, absolute error of a worn height in a step
  double share_tolerance = 2e-3;   ///< relative; the larger of both tolerances applies
  int most_steps = 100000;
};

/// The bit after this distance.
struct GlowkaWearRecord {
  double distance = 0.0;     ///< m
  std::vector<double> worn;  ///< m, on every cutter's face
  GlowkaLoads loads;         ///< of the worn bit
};

/// The records; the first is of the bit at the start.
struct GlowkaWear {
  std::vector<GlowkaWearRecord> records;
  int steps = 0, refused = 0;
  std::optional<std::size_t> worn_out;  ///< cutter that lost half its face; ends the run
};

/// Wear over metres drilled at a constant advance and speed. Per metre a cutter slides 2 pi r/d and
/// loses dy/ds = C(T) stress (2 pi r/d)/cos b. Only the force on the flat heats and wears it, not
/// that on the sharp edge (our assumption), so the law must have a stress under the flat. Starts
/// from the wear in the cutter table. Heun's method, with steps from its difference to Euler's.
/// Throws InputError for no distance, no stress, no wear coefficient, or a cutter without back
/// rake; RunError for too many steps.
GlowkaWear glowka_wear(const GlowkaBit& bit, const GlowkaLaw& law, const FlatHeat& heat,
                       const WearLaw& wear, const GlowkaRun& run, const GlowkaWearOptions& options);

}  // namespace tdbd::reference
