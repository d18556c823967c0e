#pragma once

#include "core/types.hpp"
#include "reference/literature/surface/sweep_tool.hpp"

namespace tdbd::reference {

/// A bit that rotates and advances uniformly in steps, for rocks that are cut by sweep tools: ZMap,
/// Spokes. The spatial frame and the bit's frame coincide before the first step.
struct SteadyDrilling {
  double turn = 0.0;     ///< rad per step, about +z
  double advance = 0.0;  ///< m per step, along +z
  std::vector<SweepTool> tools;
  long steps_done = 0;
  double removed = 0.0;  ///< m3
};

/// X_WB after this number of steps.
Pose pose_after(const SteadyDrilling& d, long steps);

/// The drilling of a bit from its first step on. `reach` as for sweep_tools, m.
SteadyDrilling steady_drilling(const bit::Bit& bit, double turn, double advance, double reach);

/// Makes `steps` more steps.
template <class Rock>
void drill(SteadyDrilling& d, Rock& rock, long steps) {
  for (long i = 0; i < steps; ++i)
    d.removed += cut_sweep(rock, d.tools, pose_after(d, ++d.steps_done));
}

}  // namespace tdbd::reference
