#pragma once

#include <utility>

#include "simulation/chain/chain_case.hpp"

namespace tdbd::simulation {

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

}  // namespace tdbd::simulation
