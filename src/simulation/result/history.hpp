#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "simulation/result/chain_record.hpp"
#include "simulation/result/history_columns.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// The steps so far of the next row of a history. Vectors by number of a row; empty before the first
/// step.
struct HistoryWindow {
  long steps = 0;
  std::vector<double> sum, least, greatest;

  template <class Archive>
  void serialize(Archive& a) {
    a(steps, sum, least, greatest);
  }
};

/// What a row stands for.
enum class Rows {
  of_steps,   ///< one step
  of_windows  ///< all steps since the last row: means, sums and extremes, or the last value
};

/// Records rows as `history.nc` (dimensions time and part, and cone and cutter where there are any)
/// and, sums in place of the columns by part and by cutter, as `history.csv` beside it: a Record
/// with the columns of a run. Rows of windows have means of areas, forces, velocities and powers,
/// sums of what steps removed, the last value of all else, and columns NAME_min and NAME_max of the
/// bit's sections, loads and velocities; those by part and by cutter in single precision.
class History {
 public:
  /// Creates `path.partial`. Throws RunError when it cannot.
  History(const std::filesystem::path& path, const std::vector<HistoryPart>& parts,
          const HistoryExtent& extent = {}, Rows rows = Rows::of_steps);

  /// Takes up a step. Throws RunError when `step` does not have the parts', the cones' and the
  /// cutters' number.
  void take(const HistoryRow& step);

  /// Writes a row of the steps taken up since the last one; nothing without any. Whether there was
  /// one. Throws RunError when a block cannot be written.
  bool write();

  /// A step that is a row.
  void append(const HistoryRow& row) {
    take(row);
    write();
  }

  /// The numbers of the last row, and of every row, as many.
  const std::vector<double>& last_row() const { return row_; }
  std::size_t width() const { return layout_.row_width(); }

  /// Appends what was a last_row() of this history.
  void append_again(std::span<const double> row) { record_.append(row); }

  /// The steps since the last row, for a checkpoint, and back.
  const HistoryWindow& window() const { return window_; }
  void set_window(const HistoryWindow& window) { window_ = window; }

  /// Writes what is buffered and gives the files their names. An interrupted run closes too.
  /// Throws RunError.
  void close();

 private:
  HistoryExtent extent_;
  Rows rows_;
  RecordLayout steps_, layout_;  ///< of a step; of a row
  Record record_;
  HistoryWindow window_;
  std::vector<double> numbers_, row_;  ///< of the last step; kept: no allocation
};

/// What the history of a run has: its parts, what else, and what a row stands for.
std::vector<HistoryPart> history_parts(const bit::Bit& bit);
HistoryExtent history_extent(const Case& c);
Rows rows_of(const Case& c);

/// The chain of a run whose string is one, and the motion of the bit at its end.
ChainView chain_view(const Case& c, const Simulation& s);

/// Takes the step just made into the history.
void take_step(const Case& of_run, const Simulation& s, History& history);

}  // namespace tdbd::simulation
