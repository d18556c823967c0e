#pragma once

#include <filesystem>

#include "simulation/case/case.hpp"
#include "simulation/result/run_loop.hpp"
#include "simulation/result/summary.hpp"
#include "simulation/step/energy_order.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// How a drilling case is run; `progress` is called after every step with the number of all steps.
using RunOptions = OptionsOf<void(const Simulation&, long)>;

/// The steps of a drilling case, for run_loop. The arguments must outlive them.
class DrillingSteps {
 public:
  /// `plan`: the step at which the order of the energy residual is observed; default: not at all.
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

  EnergyOrder order;  ///< as far as it was observed

 private:
  const Case& c_;
  Simulation& s_;
  long observe_at_;
};

/// Drills a case and writes its result folder; the summary last, so that a folder without one has
/// no finished run. An interruption ends the run after its step and writes everything that is
/// recorded, with status "interrupted". If a step or a write fails, the history and the surface so
/// far are kept as far as they can be written, failure.txt says what happened, and the error is
/// passed on. Throws InputError before anything is written, RunError later.
RunSummary run(const Case& c, const RunOptions& options);

/// Resumes a run that was stopped or killed: the case is that of the folder (read_stopped_case).
/// Every file of the result but timing.json is bitwise identical to that of an uninterrupted run. It
/// begins with the newest checkpoint, or, where there is none, with the start. Throws like run, and
/// InputError for checkpoints of another case or version.
RunSummary resume_run(const Case& c, const RunOptions& options);

/// The case of a folder that a run was begun in. Throws like stopped_case.
Case read_stopped_case(const std::filesystem::path& folder);

/// Resources that a run requires.
struct RunEstimate {
  double triangles = 0.0;     ///< of rock at the end, with the wall that the way adds
  double memory_bytes = 0.0;  ///< of the rock; the program itself needs some 30 MB more
  double disk_bytes = 0.0;    ///< of the result folder, checkpoints included
  double seconds = 0.0;       ///< of one thread of this machine
  long steps_tried = 0;       ///< that the seconds are taken from
};

/// Tries the first steps for some tenths of a second; `s` is as it was started, and is changed.
/// Triangles and bytes are estimated within some tens of percent, seconds within a factor of two,
/// since the hole grows.
RunEstimate estimate(const Case& c, Simulation& s);

}  // namespace tdbd::simulation
