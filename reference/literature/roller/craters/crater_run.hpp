#pragma once

#include "reference/literature/roller/craters/crater_drilling.hpp"

/// Checks, buffers and results of crater_drilling.
namespace tdbd::reference {

/// Throws InputError as described at crater_drilling.
void check_crater_drilling(const RollerBit& bit, const ToothLaw& law,
                           const RollerSchedule& schedule, const CraterDrillingOptions& options);

/// Sets the bit's own tooth radius where the options have none. Throws InputError if its teeth have
/// different radii, because a law or a table is that of one tooth.
CraterDrillingOptions with_tooth_radius(const RollerBit& bit, CraterDrillingOptions options);

/// Number of steps of the whole schedule.
long steps_of(const RollerSchedule& schedule);

/// A run with memory for all its steps and its bottom.
RollerRun empty_run(const RollerBit& bit, const RollerSchedule& schedule,
                    const CraterDrillingOptions& options);

/// Time (s) and depth (m) of the bit at the end of a step, and the evaluations needed to find it.
struct StepPlace {
  double time = 0.0, depth = 0.0;
  int evaluations = 0;
};

void add_step(RollerRun& run, const StepPlace& place, const RollerLoads& loads,
              const std::vector<double>& forces, const std::vector<double>& cone_speeds,
              const RollerSchedule& schedule);

/// Computes means and deviations after `settle` from the series.
void take_means(RollerRun& run, const RollerSchedule& schedule);

}  // namespace tdbd::reference
