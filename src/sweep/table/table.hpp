#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sweep/design/design.hpp"
#include "sweep/design/points.hpp"
#include "sweep/table/journal.hpp"

namespace tdbd::sweep {

/// Which rows no other row dominates: one that is as good in every goal and better in one (Pareto's
/// front). `rows`: a value for each goal, in the design's order; a row with a value that is not
/// finite is never on the front. 1: on it.
std::vector<char> front_of(const std::vector<std::vector<double>>& rows,
                           const std::vector<Goal>& goals);

/// A factor in the table: numbers in one unit, or texts.
struct FactorColumn {
  std::string key, unit;
  bool numbers = false;
};

/// What the planar model said of the points, and which of them are run.
struct Judged {
  std::vector<double> figure;  ///< NaN: it could not say; empty: there is no filter
  std::vector<char> kept;      ///< empty: all are
  bool keeps(std::size_t point) const { return kept.empty() || kept[point] != 0; }
};

/// The best of a filter, in number at most what it keeps; points of equal figures in their order, those that are no
/// number never.
Judged judged_by(const Filter& filter, std::vector<double> figure);

/// All points of a design with what they came to, in the order of the design.
struct Table {
  const Design* design = nullptr;
  std::vector<FactorColumn> factors;
  std::vector<std::vector<Level>> levels;  ///< of each point
  std::vector<const PointRecord*> points;  ///< null: not done yet
  std::vector<char> on_front;              ///< of a design with goals: not dominated
  Judged judged;                           ///< of a design with a filter
};

/// The table of a design as far as its points are done; the records must outlive it.
Table table_of(const Design& d, const Points& points, const std::vector<std::string>& keys,
               const PointRecords& records, const Judged& judged = {});

/// Points that are done, of either status; and those that are run at all.
long done_points(const Table& t);
long points_to_run(const Table& t);

/// NAME.nc for xarray: dimension point; one variable for each factor (under its key) and each
/// figure, status, message, case_hash, and front; the design's goals and text as attributes. The
/// bytes depend on design and program alone. NAME.csv the same as text, NAME_timing.csv the seconds
/// of each point. All are written in a folder on the same disk that is this process's own, and then
/// moved: shards that end together may all write the table. Throws RunError.
void write_table(const std::filesystem::path& netcdf_file, const Table& t,
                 const std::filesystem::path& own_folder);

/// The text of NAME.csv.
std::string to_csv(const Table& t);

}  // namespace tdbd::sweep
