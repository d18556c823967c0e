#pragma once

#include <string>
#include <vector>

#include "simulation/case/chain_statics.hpp"
#include "simulation/case/read_chain.hpp"
#include "simulation/rotate/rotate_case.hpp"

namespace tdbd::simulation {

/// A checked case of a drill string without rock: all that `tdbd string` needs.
struct ChainCase {
  std::string path;
  std::string title;
  std::vector<std::string> files;  ///< all that were read
  ChainPlan plan;
  RotateTime time;         ///< no steps: statics and modes alone
  long history_every = 1;  ///< steps between rows
  ChainOutput output;
  std::vector<CaseWarning> warnings;
  std::string resolved;  ///< TOML: all defaults, SI; itself a case that gives the same result
  std::string hash;      ///< of the resolved values and the content of all files
};

/// Reads and checks everything, runs nothing. Throws InputError that lists every mistake.
ChainCase read_chain_case(const std::string& path, const std::vector<std::string>& overrides);

/// Of the string off bottom, and with the start's load of the bit where there is one.
inline std::vector<StaticLoad> static_loads(const ChainPlan& p) {
  return static_loads(p.chain, p.bit.gravity_force, p.motion);
}

inline ChainModes chain_modes(const ChainPlan& p) {
  return chain_modes(p.chain, p.bit.mass, p.bit.inertia);
}

/// Hook load (N) and surface torque (N m) while the string is run in: the bit at a measured depth (m),
/// pipe taken away at the top.
struct DepthLoad {
  double depth = 0.0;
  double pull_up = 0.0, slack_off = 0.0, rotate = 0.0, torque = 0.0;
};

/// Of bit depths down to that of the case, for the picture called broomstick plot.
std::vector<DepthLoad> loads_by_depth(const ChainPlan& plan);

}  // namespace tdbd::simulation
