#pragma once

#include <optional>
#include <vector>

#include "core/compensated_sum.hpp"
#include "rock/cut/cut_rock.hpp"
#include "rock/maintain/maintain.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/motion.hpp"
#include "simulation/step/cone_motion.hpp"
#include "simulation/step/diagnosis.hpp"
#include "simulation/step/drive.hpp"
#include "simulation/step/load_figures.hpp"
#include "simulation/step/measure.hpp"
#include "simulation/step/trimming.hpp"

namespace tdbd::simulation {

/// Where every cubic millimetre went (formulation 2.5). Volumes in m3.
struct VolumeLedger {
  double hole_start = 0.0;  ///< hole's volume under the cap of its boundary
  CompensatedSum removed;
  CompensatedSum trimmed;  ///< of hole_volume, with the wall that was trimmed
  std::vector<CompensatedSum> removed_by_part;
  std::vector<std::vector<double>> removed_by_revolution;  ///< [revolution][part]
};

/// All that a run carries from step to step.
struct Simulation {
  rock::CuttingBit bit;
  rock::Rock rock;
  rock::MaintenanceLimits limits;
  rock::MaintenanceReport maintenance;
  VolumeLedger ledger;
  long steps_done = 0;        ///< since the motion's beginning (TimeGrid::first)
  Place place;                ///< of the bit, after the steps done
  double start_turned = 0.0;  ///< rad: Place::turned when the run began
  long start_triangles = 0;
  rock::CutReport cut;  ///< of the last step
  std::vector<ConeState> cones;
  Measures measures;                        ///< of the last step
  std::optional<dynamics::Drilling> drive;  ///< of a bit that forces move
  dynamics::Drilling drive_before;          ///< before the step at work
  BitVelocity velocity;                     ///< over the rock, at the end of the last step
  std::vector<CutOfPart> cuts;              ///< of the last step; without forces none
  BitLoads loads;                           ///< at the end of the last step, about the bit's origin
  std::vector<double> energy_by_part;       ///< J, power times step since the start
  LoadStatistics load_statistics;
  Trace trace;
  rock::CutWorkspace cut_work;
  rock::MaintenanceWorkspace maintenance_work;
  Trimming trimming;
};

/// Builds rock and bit of a case at t = 0. Throws InputError if the bit starts deeper in the rock
/// than its largest cutter's radius, or the rock cannot be built.
Simulation start(const Case& c);

/// One time step, thesis fig. 4.2: the bit moves, every part cuts, the ledger notes it, sections
/// and contact areas are measured, the force laws are asked, and the surface is maintained, and its
/// wall trimmed, when due.
void step(const Case& c, Simulation& s);

/// |start + removed + maintenance - trimmed - now| over the largest of them: tolerance::ledger
/// bounds it.
double ledger_defect(const Simulation& s);

}  // namespace tdbd::simulation
