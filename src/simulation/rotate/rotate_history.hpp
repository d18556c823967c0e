#pragma once

#include <filesystem>

#include "simulation/result/record.hpp"
#include "simulation/rotate/rotate_simulation.hpp"

namespace tdbd::simulation {

/// Records states of a rotate case: `history.nc` with dimensions time, xyz, quaternion and cone,
/// and `history.csv` with the same columns flat. Thesis: figs. 5.4, 5.5 draw from such records.
class RotateHistory {
 public:
  /// Creates `path.partial`. Throws RunError when it cannot.
  RotateHistory(const std::filesystem::path& path, const RotateCase& c);

  /// Appends the state, once for each step. Throws RunError.
  void append(const RotateCase& c, const RotateSimulation& s);

  /// See Record::close.
  void close() { record_.close(); }

 private:
  Record record_;
  std::vector<double> row_;  ///< kept from row to row: no allocation
  long last_step_ = -1;
};

}  // namespace tdbd::simulation
