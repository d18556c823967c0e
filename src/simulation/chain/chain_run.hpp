#pragma once

#include <string>
#include <utility>
#include <vector>

#include "simulation/case/read_chain.hpp"
#include "simulation/rotate/rotate_case.hpp"
#include "simulation/rotate/rotate_run.hpp"

namespace tdbd::simulation {

/// A checked case of a drill string without rock: the input of `tdbd string`.
struct ChainCase {
  std::string path;
  std::string title;
  std::vector<std::string> files;  ///< all files that were read
  ChainPlan plan;
  RotateTime time;         ///< zero steps: only statics and modes
  long history_every = 1;  ///< steps between rows
  ChainOutput output;
  std::vector<CaseWarning> warnings;
  std::string resolved;  ///< TOML with all defaults, SI; a valid case that gives the same result
  std::string hash;      ///< of the resolved values and the content of all files
};

/// Reads and checks the case; runs nothing. Throws InputError that lists all mistakes.
ChainCase read_chain_case(const std::string& path, const std::vector<std::string>& overrides);

/// Static loads of the string off bottom, and with the initial load of the bit if there is one.
inline std::vector<StaticLoad> static_loads(const ChainPlan& p) {
  return static_loads(p.chain, p.bit.gravity_force, p.motion);
}

inline ChainModes chain_modes(const ChainPlan& p) {
  return chain_modes(p.chain, p.bit.mass, p.bit.inertia);
}

/// Hook load (N) and surface torque (N m) for a bit at a measured depth (m) while the string is run
/// in; pipe is removed at the top.
struct DepthLoad {
  double depth = 0.0;
  double pull_up = 0.0, slack_off = 0.0, rotate = 0.0, torque = 0.0;
};

/// Loads for bit depths down to that of the case, for a broomstick plot.
std::vector<DepthLoad> loads_by_depth(const ChainPlan& plan);

/// Statistics of a run of a chain.
struct ChainFigures {
  double start_balance = 0.0;   ///< J
  double residual = 0.0;        ///< largest change of the balance, J
  long bit_steps_at_rest = 0;   ///< in the second half of the run
  long node_steps_at_rest = 0;  ///< sum over steps of the nodes at rest
  double least_speed = 0.0;     ///< of the bit in the second half, rad/s
  double largest_speed = 0.0;
};

/// State of a chain with its bit during a run.
struct ChainSimulation {
  string::BitOnChain state;
  string::ChainWork work;
  ChainFigures figures;
  long steps_done = 0;
  double time = 0.0;  ///< s
};

/// Creates the state of the case at t = 0.
ChainSimulation start_chain(const ChainCase& c);

/// Performs `steps` steps. Throws RunError if the state is not finite.
void advance_chain(const ChainCase& c, ChainSimulation& s, long steps);

/// Result of a run of a chain.
struct ChainOutcome {
  RunStatus status = RunStatus::completed;
  ChainSimulation end;
};

/// Computes statics and modes, runs the steps of the case, if any, and writes the result folder.
/// The summary is written last: a folder without it contains no completed run. After an
/// interruption, everything recorded so far is written. If a step or a write fails, failure.txt
/// contains the reason, and the error is rethrown. Throws InputError before anything is written,
/// RunError later.
ChainOutcome run_chain(const ChainCase& c, const RotateOptions& options);

/// The summary of a case so far, as JSON with units in its keys.
std::string summary_json(const ChainCase& c, const ChainSimulation& s, RunStatus status);

}  // namespace tdbd::simulation
