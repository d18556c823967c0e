#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "simulation/result/chain_record.hpp"
#include "simulation/result/history_columns.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// The steps so far of the next row of a history. The vectors are indexed by the position in a row
/// and are empty before the first step.
struct HistoryWindow {
  long steps = 0;
  std::vector<double> sum, least, greatest;
  std::vector<double> last;  ///< of the last step

  template <class Archive>
  void serialize(Archive& a) {
    a(steps, sum, least, greatest, last);
  }
};

/// The steps that a row represents.
enum class Rows {
  of_steps,   ///< one step
  of_windows  ///< all steps since the previous row: means, sums and extremes, or the last value
};

/// Records the rows of a run as `history.nc` and `history.csv` (see Record). The NetCDF file has
/// the dimensions time and part and, if they exist, cone and cutter; the csv has sums instead of
/// columns by part and by cutter. Rows of windows contain means of areas, forces, velocities and
/// powers, sums of removed volumes, the last value of everything else, and columns NAME_min and
/// NAME_max for the bit's sections, loads and velocities. Their columns by part and by cutter have
/// single precision.
class History {
 public:
  /// Creates `path.partial`. Throws RunError if it cannot be created.
  History(const std::filesystem::path& path, const std::vector<HistoryPart>& parts,
          const HistoryExtent& extent = {}, Rows rows = Rows::of_steps);

  /// Adds a step to the current window. Throws RunError if the numbers of parts, cones or cutters
  /// in `step` are wrong.
  void take(const HistoryRow& step);

  /// Writes a row of the steps added since the previous row, if there are any, and returns whether
  /// it wrote one. Throws RunError if a block cannot be written.
  bool write();

  /// Adds a step and writes it as a row.
  void append(const HistoryRow& row) {
    take(row);
    write();
  }

  /// Returns the numbers of the last row. All rows have the same number of values.
  const std::vector<double>& last_row() const { return row_; }
  std::size_t width() const { return layout_.row_width(); }

  /// Appends a row that was a last_row() of this history.
  void append_again(std::span<const double> row) { record_.append(row); }

  /// The steps since the last row, which a checkpoint stores and restores.
  const HistoryWindow& window() const { return window_; }
  void set_window(const HistoryWindow& window) { window_ = window; }

  /// Writes what is buffered and renames the files to their final names. Also used for interrupted
  /// runs. Throws RunError.
  void close();

 private:
  HistoryExtent extent_;
  Rows rows_;
  RecordLayout steps_, layout_;  ///< layout of a step, and of a row
  Record record_;
  HistoryWindow window_;
  std::vector<double> row_;  ///< a member so that no step allocates
};

/// The contents of a run's history: its parts, the other columns, and what a row represents.
std::vector<HistoryPart> history_parts(const bit::Bit& bit);
HistoryExtent history_extent(const Case& c);
Rows rows_of(const Case& c);

/// Returns the chain of a run whose string is one, and the motion of the bit at its end.
ChainView chain_view(const Case& c, const Simulation& s);

/// Adds the last step to the history.
void take_step(const Case& of_run, const Simulation& s, History& history);

}  // namespace tdbd::simulation
