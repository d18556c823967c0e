#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace tdbd::battery {

/// The verdict of a measurement on a claim.
enum class Verdict { holds, holds_with_limits, refuted };

/// One number that a test measured for or against a claim. The evidence page (reports/) reads
/// nothing else.
struct Evidence {
  std::string claim;      ///< slug: "chapter5/second-order", "ours/split-is-cheaper"
  std::string what;       ///< one line: what was measured, on which case
  double measured = 0.0;  ///< finite
  std::string unit;       ///< "J", "rad"; "1" when it has none
  /// "<= 1e-12", "2 +- 0.05"; for with_limits also the range of validity. At most three times the
  /// measured value, or with a reason: "<= 0.08; wide: REASON" (reports/evidence.py).
  std::string limit;
  Verdict verdict = Verdict::refuted;
};

/// Writes FOLDER/CLAIM/SLUG-OF-WHAT.json atomically, with the name of the running test and of its
/// program. The file is bitwise reproducible. FOLDER is the build folder's `evidence`, or what the
/// environment variable TDBD_EVIDENCE names. Throws std::invalid_argument when the claim is no
/// slug, `what` holds no letter, the number is not finite or no test is running, and
/// std::runtime_error when the file cannot be written.
void record(const Evidence& evidence);

/// Writes FOLDER/tables/NAME.json: {test, program, rows}, as record does. `rows` is a list of
/// objects; figures read it. Throws as record does.
void record_table(const std::string& name, const nlohmann::ordered_json& rows);

}  // namespace tdbd::battery
