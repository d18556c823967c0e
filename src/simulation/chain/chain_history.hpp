#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "simulation/chain/chain_run.hpp"
#include "simulation/result/chain_record.hpp"

namespace tdbd::simulation {

/// Recorder of a chain: `history.nc` and `history.csv` with the surface, the bit and the nodes
/// selected in the case; `string.nc` with profiles over all nodes.
class ChainHistory {
 public:
  /// Creates `.partial` files in the folder. Throws RunError if it cannot.
  ChainHistory(const std::filesystem::path& folder, const ChainCase& c);

  /// Appends a row of the history and a profile, if due. Call it once per step.
  void append(const ChainCase& c, const ChainSimulation& s);

  /// Renames the files to their final names. Throws RunError.
  void close();

 private:
  void append_row(const ChainCase& c, const ChainSimulation& s);

  Record record_;
  std::unique_ptr<ChainProfiles> profiles_;
  std::vector<double> row_;
  long last_row_ = -1, last_profile_ = -1;
};

/// Writes `static.csv` (torque and drag by element), `broomstick.csv` (hook loads by bit depth) and
/// `modes.csv` (mode shapes by node).
void write_static_tables(const std::filesystem::path& folder, const ChainCase& c);

}  // namespace tdbd::simulation
