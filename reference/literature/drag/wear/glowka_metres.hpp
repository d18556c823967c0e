#pragma once

#include <optional>

#include "reference/literature/drag/wear/glowka_bit.hpp"

namespace tdbd::reference {

/// How a run of wear over drilled metres is computed.
struct GlowkaWearOptions {
  double distance = 0.0;           ///< m, to drill
  int records = 10;                ///< at even distances, beside that of the start
  double height_tolerance = 1e-6;  ///< m, error of a step in any cutter's worn height,
  double share_tolerance = 2e-3;   ///< or this share of the height, where that is more
  int most_steps = 100000;
};

/// The bit when it has drilled so far.
struct GlowkaWearRecord {
  double distance = 0.0;     ///< m
  std::vector<double> worn;  ///< m, on every cutter's face
  GlowkaLoads loads;         ///< of the bit as worn
};

/// The records, the first of the bit as it came.
struct GlowkaWear {
  std::vector<GlowkaWearRecord> records;
  int steps = 0, refused = 0;
  std::optional<std::size_t> worn_out;  ///< the cutter that lost half its face, where the run ends
};

/// Wear over metres drilled at a constant advance and speed. Per metre a cutter slides 2 pi r/d, and
/// loses dy/ds = C(T) stress (2 pi r/d)/cos b. The force on the flat heats and wears it, not that on
/// the sharp edge (ours), so the law must have a stress under the flat. Starts from the wear in the
/// cutter table. Heun's method, steps from its difference to Euler's. Throws InputError: no
/// distance, no stress, no wear coefficient, a cutter without back rake; RunError: too many steps.
GlowkaWear glowka_wear(const GlowkaBit& bit, const GlowkaLaw& law, const FlatHeat& heat,
                       const WearLaw& wear, const GlowkaRun& run, const GlowkaWearOptions& options);

}  // namespace tdbd::reference
