#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulation/study/levels.hpp"
#include "simulation/study/variable_convergence.hpp"

namespace tdbd::simulation {

/// How many levels a study may have: it divides at least once, and halves no double more often.
inline constexpr int least_levels = 2, most_levels = 60;

/// A study: quantities of a case divided again and again, all by the same factor.
struct ConvergencePlan {
  std::string case_file;
  std::vector<std::string> overrides;
  std::vector<std::string> keys;      ///< dotted, of positive quantities: "time.step"; one or more
  int levels = 5;                     ///< how many values, the case's own the first
  double factor = 2.0;                ///< between neighbours, greater than 1
  std::optional<EndState> reference;  ///< errors are against this; none: against the next level
};

/// What a study found.
struct Convergence {
  ConvergencePlan plan;
  RunStatus status = RunStatus::completed;
  std::string title, case_hash;
  double nominal_order = 0.0;  ///< of the method in these quantities; 0: not known
  std::vector<ConvergenceLevel> levels;
  std::vector<VariableConvergence> variables;
};

/// The case with its own values of the quantities, checked. Throws InputError: a wrong case, a key
/// that is no positive quantity of it or comes twice, no key, a factor of 1 or less, a number of
/// levels out of range, a second or last level that is no right case or ends at another time.
struct ConvergenceStart {
  std::vector<double> sizes;
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

/// "rock.edge_length and time.step".
std::string keys_in_words(const ConvergencePlan& plan);

/// "difference" to the next level, or "error" against the reference; plural.
std::string error_name(const ConvergencePlan& plan);

}  // namespace tdbd::simulation
