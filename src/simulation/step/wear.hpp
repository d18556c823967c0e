#pragma once

#include <optional>
#include <vector>

#include "bit/wear/worn_piece.hpp"
#include "core/error.hpp"

namespace tdbd::simulation {

/// Wear ends the run: a flat is as large as its piece of the bit, or grows too fast. The message names it.
struct WearEnd : RunError {
  using RunError::RunError;
};

/// Wear over some time. What a flat loses where it bears is given as a height: under a steady stress it
/// loses height evenly, however large it has grown.
struct WornOff {
  double volume = 0.0;  ///< m3, elsewhere on the piece
  double height = 0.0;  ///< m: volume over the area of the flat
};

/// The wear of a piece of the bit in a run: of a cutter, a tooth or a gage pad (bit::WearSolid).
struct PieceWear {
  double volume = 0.0;  ///< m3, worn in the run, as its meshes have lost it
  double height = 0.0;  ///< m, of the flat that lost it (WearFlat)
  WornOff window{};     ///< rate times time since the last wear step
  WornOff previous{};   ///< the same of the window before
  WornOff last{};       ///< of the last time step
};

/// What rubbed on it in the last step.
struct PieceRub {
  double force = 0.0;        ///< N, normal, of all its parts
  double temperature = 0.0;  ///< K, of the flat
  double rate = 0.0;         ///< m3/s, of worn volume, not accelerated
  double flat_rate = 0.0;    ///< m3/s, of that: where the flat bears (FlatMeasure::edge)
};

/// The wear of a bit, as a restart needs it. Times are times of wear: acceleration times simulated
/// time, s. A window is what lies between two wear steps.
struct WearState {
  std::vector<PieceWear> pieces;  ///< per bit::WearSolid
  std::vector<PieceRub> rubs;     ///< per piece
  double window_time = 0.0, previous_time = 0.0;
  long window_steps = 0;         ///< time steps
  double window_distance = 0.0;  ///< m that the bit went down
  double window_weight = 0.0;    ///< N s of wear, weight on bit times time
  double window_torque = 0.0;    ///< N m s of wear, torque on bit times time
  double distance = 0.0;         ///< m of wear: acceleration times what the bit went down
  long steps = 0;                ///< wear steps taken
};

/// What wears off in a window of this time (s) in which `window` wore off at the geometry of its
/// beginning: the method of Adams and Bashforth of order 2 over windows of any length, simulation (14);
/// the first window is one of Euler's method. Never negative.
WornOff worn_after(const WearState& s, const PieceWear& c, const WornOff& window, double time);

/// The flat of a piece that loses this: half of the volume, then the height, then the other half,
/// which is of order 2. None: the flat would be as large as the piece.
std::optional<bit::WearFlat> flat_after(const bit::WearSolid& solid, const PieceWear& c,
                                        const WornOff& worn);

/// A wear step: closes the window, finds the flat of each piece's volume, and begins the next
/// window. `flats`: of the bit before and after. Throws WearEnd if a flat becomes as large as its
/// piece, and leaves `s` and `flats` unchanged.
void take_wear_step(const std::vector<bit::WearSolid>& solids, WearState& s,
                    std::vector<bit::WearFlat>& flats);

/// By how much the worn volumes differ from what the meshes lost (bit::lost_volume): the differences from
/// what is beyond the flats, summed, over all that is worn; or, if larger, the largest difference of
/// the meshes over the volume of their piece. `fresh`: the bit of the case; `worn`: as the last wear
/// step left it.
double wear_ledger_defect(const bit::Bit& fresh, const bit::Bit& worn,
                          const std::vector<bit::WearSolid>& solids, const WearState& s);

/// The bit at the distance of a wear step, per piece.
struct WearRecord {
  double distance = 0.0;  ///< m of wear
  double weight = 0.0;    ///< N, on bit, mean of the window before
  double torque = 0.0;    ///< N m, on bit, mean of the window before
  double rate = 0.0;      ///< m/s, of penetration, of the window before
  std::vector<double> height, width, volume, temperature, force;  ///< m, m, m3, K, N
};

/// Records over the distance, thinned as they become many: at most 64.
struct WearRecords {
  long every = 1;  ///< wear steps between two records
  long seen = 0;
  std::vector<WearRecord> records;
};
void add(WearRecord record, WearRecords& to);

}  // namespace tdbd::simulation
