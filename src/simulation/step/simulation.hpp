#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/compensated_sum.hpp"
#include "dynamics/drilling/drilling_step.hpp"
#include "rock/cut/cut_rock.hpp"
#include "rock/maintain/maintain.hpp"
#include "rock/maintain/renumber.hpp"
#include "rock/section/rubbing_contact.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/motion.hpp"
#include "simulation/start/rock_start.hpp"
#include "simulation/step/cone_motion.hpp"
#include "simulation/step/diagnosis.hpp"
#include "simulation/step/load_figures.hpp"
#include "simulation/step/measure.hpp"
#include "simulation/step/spalling.hpp"
#include "simulation/step/standing.hpp"
#include "simulation/step/trimming.hpp"
#include "simulation/step/wear.hpp"

namespace tdbd::simulation {

/// Where every cubic millimetre of rock went, simulation (6). Volumes in m3.
struct VolumeLedger {
  double hole_start = 0.0;  ///< hole's volume under the cap of its boundary
  CompensatedSum removed;
  CompensatedSum trimmed;  ///< of the hole, with the wall that was trimmed
  std::vector<CompensatedSum> removed_by_part;
  std::vector<std::vector<double>> removed_by_revolution;  ///< [revolution][part]
};

/// All that a restart needs beside the case: what later steps read, and what a run counts of its
/// rock. Of `rock`, the index (`grid`, `near_lists`) can be rebuilt from the surface, and the
/// steps that follow are the same to the bit.
struct State {
  long steps_done = 0;        ///< since the motion's beginning (TimeGrid::first)
  Place place;                ///< of the bit, after the steps done
  double start_turned = 0.0;  ///< rad: Place::turned when the run began
  rock::Rock rock;
  long start_triangles = 0;
  std::vector<ConeState> cones;
  std::vector<rock::Section> sections;  ///< per cutter, the last; of faces that take turns or creep
  FacePaths face_paths;                 ///< of a bit that forces move
  rock::CutReport cut;                  ///< of the last step: turns the cones in the next
  std::optional<dynamics::Drilling> drive;  ///< of a bit that forces move
  VolumeLedger ledger;
  rock::MaintenanceReport maintenance;
  Trimming trimming;
  std::vector<std::uint8_t> started;  ///< per part: its late start has come; empty: no part waits
  std::optional<WearState> wear;      ///< of a bit that wears
  std::optional<SpallingState> spalling;  ///< of a case in which rock breaks out
};

/// Whether parts of the bit still wait for their start (late_start.hpp).
enum class Waits { none, some };

/// What a wearing bit keeps (wear_step.hpp).
struct WearWork {
  Case worn;                           ///< the case with the worn bit and its mass
  std::vector<bit::WearSolid> solids;  ///< the pieces that wear, of the bit of the case
  std::vector<int> piece_of_part;      ///< per part: index into `solids`, or -1
  std::vector<bit::WearFlat> flats;    ///< per piece
  std::vector<WornOff> due;  ///< per piece: what may wear off, either way, before a wear step
};

/// What a step keeps beside the state: all of it follows from the case and the state (start_work).
struct Work {
  // Of the case.
  rock::MaintenanceLimits limits;
  double trim_height = 0.0;  ///< m, of the trimming plane above the bit's origin; 0: no trimming
  rock::CuttingBit cutting;  ///< the bit prepared, its cones at the angles of the last step
  MeasuredFaces faces;       ///< the cutters' faces prepared
  std::vector<rock::Breakout> breakouts;      ///< of `cutting`
  std::vector<rock::ContactOfPart> contacts;  ///< per part: how they are measured
  std::vector<double> creep;                  ///< m/s, per cutter: creep_of_faces
  std::vector<rock::RubbingPart> rubbing;     ///< the parts that rub and have a law
  Waits waits = Waits::none;
  std::optional<WearWork> wear;  ///< of a bit that wears
  // Of the last step.
  Measures measures;
  std::vector<CutOfPart> cuts;  ///< none without forces
  BitVelocity velocity;         ///< over the rock, at which the force laws were evaluated
  BitLoads loads;               ///< about the bit's origin
  StepRates rates;              ///< how fast the bit went on
  Standing standing;            ///< whether they were solved for with the velocity
  // Room.
  rock::CutWorkspace cut_work;
  rock::MaintenanceWorkspace maintenance_work;
  rock::TrimWorkspace trim_work;
  rock::RenumberWork renumber_work;
  MeasureWork measure_work;
  PerThread<rock::RubbingWork> rubbing_work;
  std::vector<std::vector<rock::ContactPatch>> rubbing_patches;  ///< per rubbing part
  StandingWork standing_work;
  dynamics::DrillingWork drive;
  dynamics::Drilling drive_before;  ///< the motion before the step at work
};

/// What a run says at its end of all its steps; no step reads it.
struct Statistics {
  FaceStatistics faces;
  std::vector<ConeStatistics> cones;
  LoadStatistics loads;
  std::vector<double> energy_by_part;  ///< J, power times step since the start
  Trace trace;
  StandingStatistics standing;
  WearRecords wear;
  long node_steps_at_rest = 0;  ///< of a string on a chain: nodes times steps
};

/// A run between two steps.
struct Simulation {
  State state;
  Work work;
  Statistics statistics;
};

/// The case with the bit as it is worn: `c` itself if the bit does not wear.
inline const Case& case_now(const Case& c, const Work& work) {
  return work.wear ? work.wear->worn : c;
}

/// Builds rock and bit of a case at t = 0. Throws InputError if the bit starts deeper in the rock
/// than its largest cutter's radius, or the rock cannot be built.
Simulation start(const Case& c);

/// The same with a bit that was prepared for a case of the same `bit_hash`, and the surface of a case of
/// the same start_surface_key.
Simulation start(const Case& c, rock::CuttingBit prepared, const StartSurface& surface);

/// One time step, thesis fig. 4.2: the bit drifts to its next place, its parts cut, what they met
/// is measured, the force laws are evaluated, the motion takes their kick, and when it is due the
/// surface is maintained, its wall trimmed and its mesh renumbered (step.hpp). Throws RunError where a step cannot be
/// done; where the motion diverges it is then as it was before the step.
void step(const Case& c, Simulation& s);

/// A run that goes on from what was copied or saved between two steps; it does the same to the bit
/// as if it had not been interrupted.
Simulation resume(const Case& c, State state, Statistics statistics);

/// Prepares what depends on which parts cut and rub: `bit` is that of the case with the parts that
/// have started, `cutting` the same prepared.
void prepare_parts(const Case& c, const State& state, const bit::Bit& bit, rock::CuttingBit cutting,
                   Work& work);

/// `cutting`: the prepared bit of the case, with the parts that have started.
Work start_work(const Case& c, const State& state, rock::CuttingBit cutting);
Statistics start_statistics(const Case& c);

/// |start + removed + maintenance - trimmed - now| over the largest of them: tolerance::ledger
/// bounds it. Simulation (6).
double ledger_defect(const Simulation& s);

}  // namespace tdbd::simulation
