#pragma once

#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// What a run will take, before it is made.
struct RunEstimate {
  double triangles = 0.0;     ///< of rock at the end, with the wall that the way adds
  double memory_bytes = 0.0;  ///< of the rock; the program itself needs some 30 MB more
  double disk_bytes = 0.0;    ///< of the result folder, checkpoints included
  double seconds = 0.0;       ///< of one thread of this machine
  long steps_tried = 0;       ///< that the seconds are taken from
};

/// Tries the first steps for some tenths of a second; `s` is as it was started, and is moved on. All
/// are estimates: triangles and bytes within some tens of percent, seconds within a factor of two,
/// since the hole grows.
RunEstimate estimate(const Case& c, Simulation& s);

}  // namespace tdbd::simulation
