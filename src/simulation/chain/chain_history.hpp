#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "simulation/chain/chain_simulation.hpp"
#include "simulation/result/chain_record.hpp"

namespace tdbd::simulation {

/// Records a chain: `history.nc` and `history.csv` with the surface, the bit and the nodes that the
/// case names; `string.nc` with profiles over all nodes.
class ChainHistory {
 public:
  /// Creates `.partial` files in the folder. Throws RunError when it cannot.
  ChainHistory(const std::filesystem::path& folder, const ChainCase& c);

  /// Appends a row of the history and, where one is due, a profile. Once for each step.
  void append(const ChainCase& c, const ChainSimulation& s);

  /// Gives the files their names. Throws RunError.
  void close();

 private:
  void append_row(const ChainCase& c, const ChainSimulation& s);

  Record record_;
  std::unique_ptr<ChainProfiles> profiles_;
  std::vector<double> row_;
  long last_row_ = -1, last_profile_ = -1;
};

/// Writes `static.csv` (torque and drag over elements), `broomstick.csv` (hook loads over bit depths) and
/// `modes.csv` (shapes over nodes).
void write_static_tables(const std::filesystem::path& folder, const ChainCase& c);

}  // namespace tdbd::simulation
