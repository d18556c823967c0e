#pragma once

#include "reference/literature/surface/spokes.hpp"
#include "reference/literature/surface/steady_drilling.hpp"
#include "reference/literature/surface/z_map_sweep.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::bench {

/// A case drilled by another method: the same bit, the same motion in the same steps, with every
/// cutter's sweep as the convex hull of its disc at both ends of the step. For steady cases.
template <class Rock>
struct RivalDrilling {
  reference::SteadyDrilling drilling;
  Rock rock;
};

/// In square cells of about this width (m), sampled from TDBD's surface at t = 0.
RivalDrilling<reference::ZMap> start_z_map(const simulation::Case& plan, double cell);

/// In spokes, sampled from TDBD's surface at t = 0.
RivalDrilling<reference::Spokes> start_spokes(const simulation::Case& plan, int spokes, int nodes);

template <class Rock>
void drill(RivalDrilling<Rock>& rival, long steps) {
  reference::drill(rival.drilling, rival.rock, steps);
}

}  // namespace tdbd::bench
