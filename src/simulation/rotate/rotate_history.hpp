#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "simulation/result/record.hpp"
#include "simulation/rotate/rotate_simulation.hpp"

namespace tdbd::simulation {

/// Records states of a rotate case: `history.nc` with dimensions time, xyz, quaternion and cone,
/// and `history.csv` with the same columns flat. Thesis: figs. 5.4, 5.5 draw from such records.
class RotateHistory {
 public:
  /// Creates `path.partial`. Throws RunError when it cannot.
  RotateHistory(const std::filesystem::path& path, const RotateCase& c);

  /// Appends the state, once for each step, and says whether it did. Throws RunError.
  bool append(const RotateCase& c, const RotateSimulation& s);

  /// The numbers of the last row, and of every row, as many.
  const std::vector<double>& last_row() const { return row_; }
  std::size_t width() const { return width_; }

  /// Appends what was a last_row() of this history.
  void append_again(std::span<const double> row) { record_.append(row); }

  /// The step of the last row; -1: there is none.
  long last_step() const { return last_step_; }
  void set_last_step(long step) { last_step_ = step; }

  /// See Record::close.
  void close() { record_.close(); }

 private:
  std::size_t width_;
  Record record_;
  std::vector<double> row_;  ///< kept from row to row: no allocation
  long last_step_ = -1;
};

}  // namespace tdbd::simulation
