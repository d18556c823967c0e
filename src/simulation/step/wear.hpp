#pragma once

#include <vector>

#include "bit/wear/worn_cutter.hpp"
#include "core/error.hpp"

namespace tdbd::simulation {

/// Wear ends the run: a flat is as large as its cutter, or grows too fast. The message names it.
struct WearEnd : RunError {
  using RunError::RunError;
};

/// The wear of a cutter in a run. Volumes in m3.
struct CutterWear {
  double volume = 0.0;    ///< worn in the run, as its meshes have lost it
  double height = 0.0;    ///< m, of the flat that lost it (WearFlat)
  double window = 0.0;    ///< rate times time since the last wear step
  double previous = 0.0;  ///< the same of the window before
  double last = 0.0;      ///< of the last time step
};

/// What rubbed on a cutter in the last step.
struct CutterRub {
  double force = 0.0;        ///< N, normal, of all its parts
  double temperature = 0.0;  ///< K, of the flat
  double rate = 0.0;         ///< m3/s, of worn volume, not accelerated
};

/// The wear of a bit, as a restart needs it. Times are times of wear: acceleration times simulated
/// time, s. A window is what lies between two wear steps.
struct WearState {
  std::vector<CutterWear> cutters;
  std::vector<CutterRub> rubs;  ///< per cutter
  double window_time = 0.0, previous_time = 0.0;
  long window_steps = 0;         ///< time steps
  double window_distance = 0.0;  ///< m that the bit went down
  double distance = 0.0;         ///< m of wear: acceleration times what the bit went down
  long steps = 0;                ///< wear steps taken
};

/// The volume of a cutter after a window of this time (s) in which `window` (m3) wore off at the
/// geometry of its beginning: the method of Adams and Bashforth of order 2 over windows of any
/// length, simulation (14); the first window is one of Euler's method. Never less than before.
double volume_after(const WearState& s, const CutterWear& c, double window, double time);

/// A wear step: closes the window, finds the flat of each cutter's volume, and begins the next
/// window. `flats`: of the bit before and after. Throws WearEnd if a flat becomes as large as its
/// cutter, and leaves `s` and `flats` unchanged.
void take_wear_step(const std::vector<bit::WearSolid>& solids, WearState& s,
                    std::vector<bit::WearFlat>& flats);

/// |volume beyond the flat - worn volume| over the worn volume, the largest of all cutters.
double wear_ledger_defect(const std::vector<bit::WearSolid>& solids, const WearState& s);

/// The bit at the distance of a wear step, per cutter.
struct WearRecord {
  double distance = 0.0;                                  ///< m of wear
  std::vector<double> width, volume, temperature, force;  ///< m, m3, K, N
};

/// Records over the distance, thinned as they become many: at most 64.
struct WearRecords {
  long every = 1;  ///< wear steps between two records
  long seen = 0;
  std::vector<WearRecord> records;
};
void add(WearRecord record, WearRecords& to);

}  // namespace tdbd::simulation
