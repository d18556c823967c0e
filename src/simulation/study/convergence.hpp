#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulation/study/levels.hpp"
#include "simulation/study/variable_convergence.hpp"

namespace tdbd::simulation {

/// Limits of the number of levels: at least one refinement, and no more halvings than a double
/// resolves.
inline constexpr int least_levels = 2, most_levels = 60;

/// A convergence study: quantities of a case are divided repeatedly by the same factor.
struct ConvergencePlan {
  std::string case_file;
  std::vector<std::string> overrides;
  std::vector<std::string> keys;      ///< dotted, of positive quantities: "time.step"; at least one
  int levels = 5;                     ///< number of values; the first is that of the case
  double factor = 2.0;                ///< between successive levels, greater than 1
  std::optional<EndState> reference;  ///< for errors; none: differences to the next level
};

/// Result of a study.
struct Convergence {
  ConvergencePlan plan;
  RunStatus status = RunStatus::completed;
  std::string title, case_hash;
  double nominal_order = 0.0;  ///< of the method in these quantities; 0: unknown
  std::vector<ConvergenceLevel> levels;
  std::vector<VariableConvergence> variables;
};

/// The checked case with its own values of the quantities. `check` throws InputError if the case is
/// invalid, if a key is not a positive quantity of it or occurs twice, if there is no key, if the
/// factor is at most 1, if the number of levels is out of range, or if the second or last level is
/// invalid or ends at another time.
struct ConvergenceStart {
  std::vector<double> sizes;
  std::string title, case_hash;
  std::vector<std::string> files;
  double nominal_order = 0.0;
  double duration = 0.0;  ///< s
};
ConvergenceStart check(const ConvergencePlan& plan);

/// Runs the levels in memory, one after another, with the duration of the case, and computes the
/// observed orders. Throws InputError if the levels end at different times or two have the same
/// number of steps, and RunError that names the level if one fails. An interruption ends the study
/// after the completed levels.
Convergence converge(const ConvergencePlan& plan, const ConvergenceOptions& options);

/// "rock.edge_length and time.step".
std::string keys_in_words(const ConvergencePlan& plan);

/// "differences" to the next level, or "errors" relative to the reference.
std::string error_name(const ConvergencePlan& plan);

}  // namespace tdbd::simulation
