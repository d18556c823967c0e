#pragma once

#include "reference/literature/roller/craters/crater_drilling.hpp"

/// The book-keeping of crater_drilling: what it refuses, the room it needs, what it writes down.
namespace tdbd::reference {

/// Throws InputError as crater_drilling says.
void check_crater_drilling(const RollerBit& bit, const ToothLaw& law,
                           const RollerSchedule& schedule, const CraterDrillingOptions& options);

/// The options with the bit's own tooth radius where they give none. Throws InputError when its teeth have
/// several: a law or a table is that of one tooth.
CraterDrillingOptions with_tooth_radius(const RollerBit& bit, CraterDrillingOptions options);

/// Steps of the whole schedule.
long steps_of(const RollerSchedule& schedule);

/// A run with room for all its steps and its bottom.
RollerRun empty_run(const RollerBit& bit, const RollerSchedule& schedule,
                    const CraterDrillingOptions& options);

/// Time (s), depth (m) of the bit at the end of a step, and what finding it cost.
struct StepPlace {
  double time = 0.0, depth = 0.0;
  int evaluations = 0;
};

void add_step(RollerRun& run, const StepPlace& place, const RollerLoads& loads,
              const std::vector<double>& forces, const std::vector<double>& cone_speeds,
              const RollerSchedule& schedule);

/// From the series: means and deviations after `settle`.
void take_means(RollerRun& run, const RollerSchedule& schedule);

}  // namespace tdbd::reference
