#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/compensated_sum.hpp"
#include "dynamics/drilling/drilling_step.hpp"
#include "rock/cut/cut_rock.hpp"
#include "rock/maintain/collapse.hpp"
#include "rock/maintain/maintain.hpp"
#include "rock/rock.hpp"
#include "rock/section/rubbing_contact.hpp"
#include "rock/start/space_order.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/motion.hpp"
#include "simulation/start/rock_start.hpp"
#include "simulation/step/diagnosis.hpp"
#include "simulation/step/drive.hpp"
#include "simulation/step/implicit_step.hpp"
#include "simulation/step/loads.hpp"
#include "simulation/step/measure.hpp"
#include "simulation/step/wear.hpp"

namespace tdbd::simulation {

/// State of spalling, sufficient for a restart.
struct SpallingState {
  std::vector<rock::EngagedEnds> ends;     ///< per cutter, from the last section of its face
  std::vector<CompensatedSum> broken_out;  ///< m3, per cutter, part of its removed volume

  template <class Archive>
  void serialize(Archive& a) {
    a(ends, broken_out);
  }
};

/// Nothing if no rock breaks out in the case.
std::optional<SpallingState> start_spalling(const SpallingPlan& plan);

/// Adds the bodies that break out rock around the faces to the cutting bit, and returns them. Empty
/// if no rock breaks out.
std::vector<rock::Breakout> breakouts_of(const Case& c, const bit::Bit& bit,
                                         const MeasuredFaces& faces, rock::CuttingBit& cutting);

/// Called before a cut: places the start of cracks at the ends of the engaged edges in the last
/// sections, unless the rock at the tip of the face does not break out. `X_WB` is the pose of the
/// bit relative to the rock.
void place_breakouts(const Case& c, const Pose& X_WB, const std::vector<rock::Breakout>& breakouts,
                     const SpallingState& state, rock::CuttingBit& cutting);

/// Called after a cut and its measurements: stores the broken-out volume and where the next cracks
/// start.
void follow_breakouts(const bit::Bit& bit, const rock::CutReport& cut, const Measures& measures,
                      SpallingState& state);

/// Progress of trimming the wall above the bit (rock.trim).
struct Trimming {
  double done_W = -1e300;  ///< m: z of the last plane
  long triangles = 0;      ///< removed

  template <class Archive>
  void serialize(Archive& a) {
    a(done_W, triangles);
  }
};

/// Height of the trimming plane above the origin of the bit, m; 0 if the case does not trim. All
/// cutting parts are below it. Throws InputError if rock.trim is smaller than the height of the bit
/// plus some edge lengths of wall.
double trim_height(const Case& c);

/// Trims above the plane at this z (m) if it has moved down by at least an edge length (m) since
/// the last time. Returns the volume of the hole that was removed with the wall, m3.
double trim(double edge_length, double plane_W, const rock::MaintenanceLimits& limits,
            rock::Rock& rock, Trimming& trimming, rock::TrimWorkspace& work);

/// Volume balance of the rock, simulation (6). Volumes in m3.
struct VolumeLedger {
  double hole_start = 0.0;  ///< volume of the hole below the cap of its boundary at the start
  CompensatedSum removed;
  CompensatedSum trimmed;  ///< volume of the hole removed with the trimmed wall
  std::vector<CompensatedSum> removed_by_part;
  std::vector<std::vector<double>> removed_by_revolution;  ///< [revolution][part]

  template <class Archive>
  void serialize(Archive& a) {
    a(hole_start, removed, trimmed, removed_by_part, removed_by_revolution);
  }
};

/// Everything that a restart needs in addition to the case: data read by later steps, and counters
/// of the rock. In `rock`, the index (`grid`, `near_lists`) can be rebuilt from the surface; the
/// following steps are then bitwise identical.
struct State {
  long steps_done = 0;        ///< since the start of the motion (TimeGrid::first)
  Place place;                ///< of the bit, after steps_done
  double start_turned = 0.0;  ///< rad: Place::turned at the start of the run
  rock::Rock rock;
  long start_triangles = 0;
  std::vector<ConeState> cones;
  std::vector<rock::Section> sections;      ///< per cutter, last; if faces take turns or creep
  FacePaths face_paths;                     ///< used in free motion
  rock::CutReport cut;                      ///< of the last step; rolls the cones in the next
  std::optional<dynamics::Drilling> drive;  ///< used in free motion
  VolumeLedger ledger;
  rock::MaintenanceReport maintenance;
  Trimming trimming;
  std::vector<std::uint8_t> started;  ///< per part: late start has occurred; empty: no part waits
  std::optional<WearState> wear;      ///< used if the bit wears
  std::optional<SpallingState> spalling;  ///< used if rock breaks out

  template <class Archive>
  void serialize(Archive& a) {
    a(steps_done, place, start_turned, rock, start_triangles, cones, sections, face_paths, cut,
      drive, ledger, maintenance, trimming, started, wear, spalling);
  }
};

/// Whether parts of the bit are still waiting for their start (step.hpp).
enum class Waits { none, some };

/// Derived data of a wearing bit (wear_step.hpp).
struct WearWork {
  Case worn;                           ///< the case with the worn bit and its mass
  std::vector<bit::WearSolid> solids;  ///< the pieces that wear, of the bit of the case
  std::vector<int> piece_of_part;      ///< per part: index into `solids`, or -1
  std::vector<bit::WearFlat> flats;    ///< per piece
  std::vector<WearAmount>
      due;  ///< per piece: limits of the wear, of either kind, before a wear step
};

/// Data of a step that is not part of the state. It can be recomputed from the case and the state
/// (start_work).
struct Work {
  // Derived from the case.
  rock::MaintenanceLimits limits;
  double trim_height = 0.0;  ///< m, of the trimming plane above the bit's origin; 0: none
  rock::CuttingBit cutting;  ///< the prepared bit with its cones at the angles of the last step
  MeasuredFaces faces;       ///< the prepared faces of the cutters
  std::vector<rock::Breakout> breakouts;      ///< of `cutting`
  std::vector<rock::ContactOfPart> contacts;  ///< per part: how contacts are measured
  std::vector<double> creep;                  ///< m/s, per cutter: see creep_speeds
  std::vector<rock::RubbingPart> rubbing;     ///< the rubbing parts that have a law
  Waits waits = Waits::none;
  std::optional<WearWork> wear;  ///< used if the bit wears
  // Results of the last step.
  Measures measures;
  std::vector<CutOfPart> cuts;  ///< empty without forces
  BitVelocity velocity;         ///< relative to the rock, at which the force laws were evaluated
  BitLoads loads;               ///< about the origin of the bit
  StepRates rates;              ///< progress of the bit
  ImplicitOutcome standing;     ///< whether the loads were computed implicitly
  // Buffers.
  rock::CutWorkspace cut_work;
  rock::MaintenanceWorkspace maintenance_work;
  rock::TrimWorkspace trim_work;
  rock::RenumberWork renumber_work;
  MeasureWork measure_work;
  PerThread<rock::RubbingWork> rubbing_work;
  std::vector<std::vector<rock::ContactPatch>> rubbing_patches;  ///< per rubbing part
  ImplicitStepWork standing_work;
  dynamics::DrillingWork drive;
  dynamics::Drilling drive_before;  ///< motion before the current step
};

/// Statistics over all steps, reported at the end of a run. Steps do not read them.
struct Statistics {
  FaceStatistics faces;
  std::vector<ConeStatistics> cones;
  LoadStatistics loads;
  std::vector<double> energy_by_part;  ///< J, power times step, since the start
  Trace trace;
  ImplicitStatistics standing;
  WearRecords wear;
  long node_steps_at_rest = 0;  ///< for a chained string: sum over steps of the nodes at rest

  template <class Archive>
  void serialize(Archive& a) {
    a(faces, cones, loads, energy_by_part, trace, standing, wear, node_steps_at_rest);
  }
};

/// A run between two steps.
struct Simulation {
  State state;
  Work work;
  Statistics statistics;
};

/// The case with the bit in its worn state; `c` itself if the bit does not wear.
inline const Case& case_now(const Case& c, const Work& work) {
  return work.wear ? work.wear->worn : c;
}

/// Creates rock and bit of a case at t = 0. Throws InputError if the bit starts deeper in the rock
/// than the radius of its largest cutter, or if the rock cannot be created.
Simulation start(const Case& c);

/// The same with a bit that was prepared for a case with the same `bit_hash`, and the surface of a
/// case with the same start_surface_key.
Simulation start(const Case& c, rock::CuttingBit prepared, const StartSurface& surface);

/// One time step, thesis fig. 4.2 (see step.hpp). The bit moves to its next pose, its parts cut,
/// sections and contacts are measured, the force laws are evaluated, and the motion gets their
/// impulse. If due, the surface is maintained, its wall trimmed and its mesh renumbered. Throws
/// RunError if a step fails; if the motion diverges, it is then restored to that before the step.
void step(const Case& c, Simulation& s);

/// Resumes a run that was copied or saved between two steps. The results are bitwise identical to
/// those of an uninterrupted run.
Simulation resume(const Case& c, State state, Statistics statistics);

/// Prepares the data that depends on which parts cut and rub. `bit` is the bit of the case with the
/// parts that have started, `cutting` the same bit prepared.
void prepare_parts(const Case& c, const State& state, const bit::Bit& bit, rock::CuttingBit cutting,
                   Work& work);

/// Recomputes Work. `cutting` is the prepared bit of the case with the parts that have started.
Work start_work(const Case& c, const State& state, rock::CuttingBit cutting);
Statistics start_statistics(const Case& c);

/// Residual of the volume ledger: |start + removed + maintenance - trimmed - now| relative to the
/// largest of these terms. At most tolerance::ledger. Simulation (6).
double ledger_defect(const Simulation& s);

}  // namespace tdbd::simulation
