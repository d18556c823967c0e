#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "simulation/case/chain_statics.hpp"

namespace tdbd::simulation {

/// What a summary reports of a string on a chain.
struct StringFigures {
  double length = 0.0, element_length = 0.0;  ///< m
  int elements = 0;
  std::vector<StaticLoad> statics;
  ChainModes modes;
  double longest_step = 0.0;  ///< that is stable, s
  CourantNumbers courant;
  double node_rest_share = 0.0;  ///< of nodes times steps
};

/// `at_rest`: nodes times steps that were at rest, of this number of steps.
double node_rest_share(const string::Chain& chain, long at_rest, long steps);

/// What does not depend on time steps: lengths, static loads, frequencies.
nlohmann::ordered_json statics_json(const StringFigures& figures);

/// What does: the longest stable step, Courant numbers, the share of node-steps at rest.
nlohmann::ordered_json steps_json(const StringFigures& figures);

}  // namespace tdbd::simulation
