#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/observed_order.hpp"
#include "simulation/result/summary.hpp"
#include "simulation/study/state_variables.hpp"

namespace tdbd::simulation {

/// A study: one quantity of a case divided again and again.
struct ConvergencePlan {
  std::string case_file;
  std::vector<std::string> overrides;
  std::string key;                    ///< dotted, of a positive quantity: "time.step"
  int levels = 5;                     ///< how many values, the case's own the first
  double factor = 2.0;                ///< between neighbours, greater than 1
  std::optional<EndState> reference;  ///< errors are against this; none: against the next level
};

/// One value of the quantity, and what the case came to with it.
struct ConvergenceLevel {
  double size = 0.0;  ///< of the quantity, SI; for time.step the step that was used
  long steps = 0;
  EndState end;
};

/// How one variable converges.
struct VariableConvergence {
  std::string name, units;
  double scale = 0.0;               ///< largest size over levels: errors are relative to it
  std::vector<double> differences;  ///< to the next level or to the reference; absolute
  ObservedOrder order;
};

/// What a study found.
struct Convergence {
  ConvergencePlan plan;
  RunStatus status = RunStatus::completed;
  std::string title, case_hash;
  double nominal_order = 0.0;  ///< of the method in this quantity; 0: not known
  std::vector<ConvergenceLevel> levels;
  std::vector<VariableConvergence> variables;
};

/// How a study is carried out.
struct ConvergenceOptions {
  int threads = 1;
  const std::atomic<bool>* interrupted = nullptr;
  /// Called now and then: level from 1, steps done, steps in all.
  std::function<void(int, long, long)> progress;
};

/// The case with its own value of the quantity, checked. Throws InputError: a wrong case, a key
/// that is no positive quantity of it, a factor of 1 or less, a second or last level that is no
/// right case or ends at another time.
struct ConvergenceStart {
  double size = 0.0;
  std::string title, case_hash;
  std::vector<std::string> files;
  double nominal_order = 0.0;
  double duration = 0.0;  ///< s
};
ConvergenceStart check(const ConvergencePlan& plan);

/// Runs the levels in memory, one after another, with the duration of the case, and observes the
/// orders. Throws InputError when the levels end at different times or two take as many steps,
/// RunError that names the level when one fails. An interruption ends the study after the levels
/// that are done.
Convergence converge(const ConvergencePlan& plan, const ConvergenceOptions& options);

/// "difference" to the next level, or "error" against the reference; plural.
std::string error_name(const ConvergencePlan& plan);

}  // namespace tdbd::simulation
