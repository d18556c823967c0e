#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "io/output_folder.hpp"
#include "sweep/design/design.hpp"
#include "sweep/point/run_point.hpp"

namespace tdbd::sweep {

/// A point as stored in a journal.
struct PointRecord {
  PointOutcome outcome;
  double seconds = 0.0;  ///< wall time
};

/// Points by key (point_keys).
using PointRecords = std::map<std::string, PointRecord>;

/// The points that one process adds to FOLDER/I-of-N/points.jsonl, each as a line with a hash of
/// its bytes. A process that is killed leaves at most one incomplete line, at the end, which the
/// next process to write there removes.
class Journal {
 public:
  /// Locks the folder, and creates it if it is missing. Throws InputError if another process writes
  /// there, RunError if it cannot be written.
  explicit Journal(const std::filesystem::path& folder);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Appends one whole line or nothing. Throws RunError.
  void add(const std::string& key, const PointRecord& record);

  /// A folder to which no other process writes during the lifetime of this object.
  std::filesystem::path folder() const { return file_.parent_path(); }

 private:
  std::filesystem::path file_;
  FolderLock lock_;
  int descriptor_ = -1;
};

/// Reads the points of all journals below a folder, by any process. An incomplete last line is
/// ignored. Throws RunError with the file and line of any other line that is incomplete or was
/// changed.
PointRecords read_journals(const std::filesystem::path& folder);

/// Why a filter keeps a point: it is one of the best, or it is run to measure how well the filter's
/// values agree with results over the whole range.
enum class KeptAs : signed char { left_out, best, sample };

/// The results of the planar model for the points, and which of them are run.
struct Judged {
  std::vector<double> figure = {};  ///< NaN if it failed; empty: there is no filter
  std::vector<KeptAs> kept = {};    ///< empty: all are kept
  double unchanged = std::numeric_limits<double>::quiet_NaN();  ///< of the case without the factors
  bool keeps(std::size_t point) const { return kept.empty() || kept[point] != KeptAs::left_out; }
};

/// Selects the best points of a filter, at most the number that it keeps, and samples from the rest:
/// the middles of equal shares of the ranking. Points with equal figures are ranked in their order;
/// points whose figure is not a number are never selected.
Judged judged_by(const Filter& filter, std::vector<double> figure);

/// Spearman's rank correlation of two lists of equal length, with mean ranks for equal values.
/// Pairs with a value that is not a number are omitted. NaN for fewer than three pairs, or if one
/// list has a single value.
double rank_correlation(std::span<const double> a, std::span<const double> b);

/// A correlation below this is reported as a filter that does not follow the results.
inline constexpr double weak_correlation = 0.5;

/// How well the values of a filter follow the results of the points that were run.
struct FilterReport {
  std::string filter;  ///< "planar.imbalance"
  std::string figure;  ///< the drilled figure that is compared (compared_figure)
  long points = 0;     ///< with both values: the best, the samples and the unchanged case
  long best = 0;       ///< among them, those that the filter finds best
  double of_all = 0.0, of_best = 0.0;                     ///< rank_correlation
  double unchanged_filter = 0.0, unchanged_figure = 0.0;  ///< NaN: failed
  std::string unchanged_message;  ///< why the unchanged case failed; empty: it did not
  long best_point = -1;           ///< with the best figure; -1: none
  double best_figure = 0.0;
};

/// The drilled figure with which a filter is compared: the one of the same name, else that of the
/// first goal, else the first figure.
std::size_t compared_figure(const Design& d);

/// Compares the filter of a design with the results. `points`: null if not completed. `unchanged`:
/// the case without the factors; null if not completed.
FilterReport filter_report(const Design& d, const Judged& judged,
                           std::span<const PointRecord* const> points,
                           const PointRecord* unchanged);

/// The text of NAME_filter.csv: the unchanged case and every point that the filter keeps, with the
/// filter's value and the figures.
std::string filter_csv(const Design& d, const Judged& judged,
                       std::span<const PointRecord* const> points, const PointRecord* unchanged);

}  // namespace tdbd::sweep
