#pragma once

#include <optional>
#include <vector>

#include "bit/wear/wear.hpp"
#include "core/error.hpp"

namespace tdbd::simulation {

/// Wear ends the run: a flat is as large as its piece of the bit, or grows too fast. The message
/// names the piece.
struct WearEnd : RunError {
  using RunError::RunError;
};

/// Wear over some time. The loss of a bearing flat is given as a height: under a steady stress the
/// height decreases uniformly, independent of the size of the flat.
struct WearAmount {
  double volume = 0.0;  ///< m3, on the rest of the piece
  double height = 0.0;  ///< m: volume over the area of the flat

  template <class Archive>
  void serialize(Archive& a) {
    a(volume, height);
  }
};

/// The wear of a piece of the bit in a run: a cutter, a tooth or a gage pad (bit::WearSolid).
struct PieceWear {
  double volume = 0.0;    ///< m3, worn in the run, removed from the meshes
  double height = 0.0;    ///< m, of the flat for this volume (WearFlat)
  WearAmount window{};    ///< rate times time since the last wear step
  WearAmount previous{};  ///< the same for the previous window
  WearAmount last{};      ///< of the last time step

  template <class Archive>
  void serialize(Archive& a) {
    a(volume, height, window, previous, last);
  }
};

/// Friction on a piece in the last step.
struct PieceRub {
  double force = 0.0;        ///< N, normal, sum over its parts
  double temperature = 0.0;  ///< K, of the flat
  double rate = 0.0;         ///< m3/s, wear rate, not accelerated
  double flat_rate = 0.0;    ///< m3/s, part of it where the flat bears (FlatMeasure::edge)

  template <class Archive>
  void serialize(Archive& a) {
    a(force, temperature, rate, flat_rate);
  }
};

/// The wear of a bit, sufficient for a restart. Times are wear times: acceleration times simulated
/// time, s. A window is the time between two wear steps.
struct WearState {
  std::vector<PieceWear> pieces;  ///< one per bit::WearSolid
  std::vector<PieceRub> rubs;     ///< one per piece
  double window_time = 0.0, previous_time = 0.0;
  long window_steps = 0;         ///< time steps
  double window_distance = 0.0;  ///< m, downward displacement of the bit
  double window_weight = 0.0;    ///< N s, integral of the weight on bit over wear time
  double window_torque = 0.0;    ///< N m s, integral of the torque on bit over wear time
  double distance = 0.0;         ///< m, acceleration times downward displacement
  long steps = 0;                ///< number of wear steps

  template <class Archive>
  void serialize(Archive& a) {
    a(pieces, rubs, window_time, previous_time, window_steps, window_distance, window_weight,
      window_torque, distance, steps);
  }
};

/// Extrapolated wear over a window of `time` (s). `window` is the wear computed at the geometry of
/// its start. Uses the second-order Adams-Bashforth method for windows of variable length,
/// simulation (14), and Euler's method for the first window. Never negative.
WearAmount worn_after(const WearState& s, const PieceWear& c, const WearAmount& window,
                      double time);

/// The flat of a piece after this wear: half of the volume, then the height, then the other half,
/// which is second-order accurate. Nothing if the flat would be as large as the piece.
std::optional<bit::WearFlat> flat_after(const bit::WearSolid& solid, const PieceWear& c,
                                        const WearAmount& worn);

/// A wear step: closes the window, computes the flat for the volume of each piece, and starts the
/// next window. `flats` are those of the bit before and after the step. Throws WearEnd if a flat
/// becomes as large as its piece; `s` and `flats` are then unchanged.
void take_wear_step(const std::vector<bit::WearSolid>& solids, WearState& s,
                    std::vector<bit::WearFlat>& flats);

/// Relative difference between worn volumes and volumes lost by the meshes (bit::lost_volume): the
/// larger of the summed differences beyond the flats relative to the worn volume, and the largest
/// difference of a piece's meshes relative to its volume. `fresh` is the bit of the case, `worn`
/// that of the last wear step.
double wear_ledger_defect(const bit::Bit& fresh, const bit::Bit& worn,
                          const std::vector<bit::WearSolid>& solids, const WearState& s);

/// State of the wear at a distance, at a wear step; vectors have one entry per piece.
struct WearRecord {
  double distance = 0.0;  ///< m, including the acceleration
  double weight = 0.0;    ///< N, on bit, mean over the previous window
  double torque = 0.0;    ///< N m, on bit, mean over the previous window
  double rate = 0.0;      ///< m/s, rate of penetration in the previous window
  std::vector<double> height, width, volume, temperature, force;  ///< m, m, m3, K, N

  template <class Archive>
  void serialize(Archive& a) {
    a(distance, weight, torque, rate, height, width, volume, temperature, force);
  }
};

/// Records over the distance, at most 64. If there are more, every other one is dropped.
struct WearRecords {
  long every = 1;  ///< number of wear steps between two records
  long seen = 0;
  std::vector<WearRecord> records;

  template <class Archive>
  void serialize(Archive& a) {
    a(every, seen, records);
  }
};
void add(WearRecord record, WearRecords& to);

}  // namespace tdbd::simulation
