#pragma once

#include <filesystem>

#include "simulation/case/case.hpp"
#include "simulation/result/run_loop.hpp"
#include "simulation/result/summary.hpp"
#include "simulation/step/energy_order.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// Options of a drilling run. `progress` is called after every step with the total number of steps.
using RunOptions = OptionsOf<void(const Simulation&, long)>;

/// The steps of a drilling case, for run_loop. The arguments must outlive them.
class DrillingSteps {
 public:
  /// `plan`: the step at which the order of the energy residual is observed; by default it is not.
  DrillingSteps(const Case& c, Simulation& s, const EnergyOrderPlan& plan = {});

  long done() const { return s_.state.steps_done; }
  long all() const { return c_.time.steps; }
  double time() const { return time_at(c_.time, done()); }
  void prepare();
  long advance();
  void finish();
  template <class Progress>
  void report(const Progress& progress) const {
    progress(s_, all());
  }

  EnergyOrder order;  ///< as far as it is observed

 private:
  const Case& c_;
  Simulation& s_;
  long observe_at_;
};

/// Drills a case and writes its result folder. The summary is written last, so a folder without one
/// has no finished run. An interruption ends the run after the current step and writes everything
/// that was recorded, with status "interrupted". If a step or a write fails, the history and the
/// surface so far are kept as far as they can be written, the reason is written to failure.txt, and
/// RunError is thrown. Throws InputError before anything is written, RunError later.
RunSummary run(const Case& c, const RunOptions& options);

/// Resumes a run that was stopped or killed. The case must be that of the folder
/// (read_stopped_case). All files of the result except timing.json are bitwise identical to those
/// of an uninterrupted run. Begins with the newest checkpoint or, if there is none, with the start.
/// Throws like run, and InputError for checkpoints of another case or version.
RunSummary resume_run(const Case& c, const RunOptions& options);

/// Returns the case with which the run in a folder was begun. Throws like stopped_case.
Case read_stopped_case(const std::filesystem::path& folder);

/// Resources that a run requires.
struct RunEstimate {
  double triangles = 0.0;     ///< of the rock at the end, including the new wall along the path
  double memory_bytes = 0.0;  ///< of the rock; the program itself needs about 30 MB more
  double disk_bytes = 0.0;    ///< of the result folder, checkpoints included
  double seconds = 0.0;       ///< on one thread of this machine
  long steps_tried = 0;       ///< number of steps from which the seconds were measured
};

/// Tries the first steps for some tenths of a second. `s`: the simulation at its start, which is
/// modified. The estimate of triangles and bytes is accurate within some tens of percent, that of
/// seconds within a factor of two, because the hole grows.
RunEstimate estimate(const Case& c, Simulation& s);

}  // namespace tdbd::simulation
