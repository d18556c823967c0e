#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "simulation/step/diagnosis.hpp"

namespace tdbd::simulation {

/// The change of a mean from the first to the second half of the recorded steps.
struct MeanChange {
  std::string name;          ///< key of the mean in summary.json
  double relative = 0.0;     ///< second mean minus first, over the larger magnitude of the two
  double t = 0.0;            ///< the change over its standard error
  bool is_drifting = false;  ///< |t| and the relative change both exceed their limits
};

/// Whether the means of a run are those of a steady state.
struct SteadyState {
  std::optional<bool> is_steady;  ///< nothing: not decided, see `reason`
  std::string reason;             ///< why it is not decided, or ""
  double revolutions = 0.0;       ///< of the bit that the means cover
  std::vector<MeanChange> changes;
};

/// Limit of |t|: Student's t with 14 degrees of freedom. A steady run exceeds it with a probability
/// of 5 % in at least one of the four means.
inline constexpr double drift_t = 2.863994;

/// Smallest relative change of a mean that matters.
inline constexpr double smallest_drift = 0.01;

/// Compares the means of weight, torque, rate and rotary speed over the first and the second half
/// of the recorded steps (Geweke, "Evaluating the accuracy of sampling-based approaches to the
/// calculation of posterior moments", Bayesian Statistics 4, 1992; he compares the first tenth with
/// the last half). Standard errors are those of the means of eight batches in each half, which are
/// nearly independent although steps are not (Schmeiser, Oper. Res. 30:556, 1982). A mean drifts if
/// it changes by more than chance explains and by more than smallest_drift. The result is not
/// decided if the steps cover less than one revolution, or are fewer than the batches.
SteadyState steady_state(const Trace& trace);

/// Returns "steady_test" of summary.json.
nlohmann::ordered_json to_json(const SteadyState& state);

/// Describes the means that drift: "the weight on bit by +12 %, the torque by +11 %". Empty if none
/// does.
std::string drifting_means(const SteadyState& state);

}  // namespace tdbd::simulation
