#pragma once

#include <exception>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "dynamics/rotation/step.hpp"
#include "io/checkpoint.hpp"
#include "io/record.hpp"
#include "simulation/result/summary.hpp"
#include "simulation/rotate/rotate_case.hpp"

namespace tdbd::simulation {

/// Conserved quantities: their values at the start and the largest changes over all steps. Momenta
/// in N m s, energies in J.
struct Invariants {
  Vec3 momentum_W = Vec3::Zero();    ///< at the start
  std::vector<double> cone_momenta;  ///< at the start
  double energy = 0.0;               ///< at the start, kinetic and potential
  double energy_scale = 0.0;         ///< |T0| + |V0| + |gravity_moment|; 1 if that is 0
  double energy_drift = 0.0;         ///< |E - E0|
  double momentum_drift_squared = 0.0;
  double vertical_drift = 0.0;       ///< |pi_z - pi_z0|
  double cone_momentum_drift = 0.0;  ///< of any cone
  double quaternion_defect = 0.0;    ///< ||q|^2 - 1|
  double largest_speed = 0.0;        ///< rad/s, of the body after a step

  template <class Archive>
  void serialize(Archive& a) {
    a(momentum_W, cone_momenta, energy, energy_scale, energy_drift, momentum_drift_squared,
      vertical_drift, cone_momentum_drift, quaternion_defect, largest_speed);
  }
};

/// The state of a rotate case during a run.
struct RotateSimulation {
  dynamics::Rotating rotating;
  Invariants invariants;
  long steps_done = 0;

  template <class Archive>
  void serialize(Archive& a) {
    a(rotating, invariants, steps_done);
  }
};

/// Returns warnings about a run whose step is too long: the energy of a body without applied torques
/// and damping has changed by more than 1 % of its scale, or the body has turned by more than 0.5 rad
/// in a step although it did not at the start. Both are outside the range of the integrators.
std::vector<CaseWarning> end_warnings(const RotateCase& c, const RotateSimulation& s);

/// Returns the kinetic and potential energy, J.
double total_energy(const RotateCase& c, const dynamics::RotationState& s);

/// Returns the angle about the space's z axis by swing-twist decomposition, unwrapped, rad.
double twist(const dynamics::RotationState& s);

/// Returns the simulation of a case at t = 0.
RotateSimulation start(const RotateCase& c);

/// Makes `steps` more steps and updates the drifts of the invariants at each. Throws RunError if
/// an implicit drift does not converge or the state is no longer finite. The state before a
/// failing step is kept if possible.
void advance(const RotateCase& c, RotateSimulation& s, long steps);

// The files of a rotation: history, checkpoints, summary.

/// Records states of a rotate case: `history.nc` with dimensions time, xyz, quaternion and cone,
/// and `history.csv` with one column per component. Thesis: figs. 5.4 and 5.5 show such records.
class RotateHistory {
 public:
  /// Creates `path.partial`. Throws RunError if it cannot be created.
  RotateHistory(const std::filesystem::path& path, const RotateCase& c);

  /// Appends the state unless this step was appended before, and returns whether it did. Throws
  /// RunError.
  bool append(const RotateCase& c, const RotateSimulation& s);

  /// Returns the numbers of the last row. All rows have the same number of values.
  const std::vector<double>& last_row() const { return row_; }
  std::size_t width() const { return width_; }

  /// Appends a row that was a last_row() of this history.
  void append_again(std::span<const double> row) { record_.append(row); }

  /// Returns the step of the last row; -1 if there is none.
  long last_step() const { return last_step_; }
  void set_last_step(long step) { last_step_ = step; }

  /// See Record::close.
  void close() { record_.close(); }

 private:
  std::size_t width_;
  Record record_;
  std::vector<double> row_;  ///< reused from row to row, to avoid allocations
  long last_step_ = -1;
};

/// How much of its history a rotation has written.
struct RotateWritten {
  long rows = 0;
  long last_step = -1;  ///< of the last row

  template <class Archive>
  void serialize(Archive& a) {
    a(rows, last_step);
  }
};

/// The saved state of a rotation between two steps.
struct RotateCheckpoint {
  RotateSimulation simulation;
  RotateWritten written;

  long steps_done() const { return simulation.steps_done; }
};

/// Writes a checkpoint completely and forces it to the disk, or leaves no file. Throws RunError.
void write_rotate_checkpoint(const std::filesystem::path& path, const RotateCase& c,
                             const RotateSimulation& s, const RotateWritten& written);

/// Reads a checkpoint. Throws like read_checkpoint.
RotateCheckpoint read_rotate_checkpoint(const std::filesystem::path& path, const RotateCase& c);

/// Records a rotation in its folder, for run_loop. The arguments must outlive the recorder.
class RotateRecorder {
 public:
  RotateRecorder(const RotateCase& c, const RotateSimulation& s, const OutputFolder& folder,
                 const CheckpointKeeper::Warn& warn)
      : c_(c), s_(s), history_(folder.history(), c), keeper_(folder, c.checkpoint_every, warn) {}

  void restore(const RotateWritten& written);
  void begin();
  void record();
  void close(RunStatus status);
  void keep_so_far(const std::exception& failure);

 private:
  void keep_checkpoint();

  const RotateCase& c_;
  const RotateSimulation& s_;
  RotateHistory history_;
  CheckpointKeeper keeper_;
};

/// Returns the answer of a rotation for a reader, a line for each: turns, speed and axis at the end,
/// energy and momentum.
std::vector<std::string> answer_lines(const RotateCase& c, const RotateSimulation& s);

/// Returns the summary of a rotate case so far as JSON. Units that are not in its keys: attitude
/// (rows of R_WB), momenta and cone momenta in N m s, angular velocity (bit frame) and cone spins
/// in rad/s, cone angles in rad, energies in J. Numbers have as many digits as are required to read
/// them back exactly. Drifts are the largest over all steps; energy drifts are divided by
/// `energy_scale`. The text depends on the case only.
std::string summary_json(const RotateCase& c, const RotateSimulation& s, RunStatus status);

}  // namespace tdbd::simulation
