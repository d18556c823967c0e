#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sweep/design/design.hpp"
#include "sweep/table/journal.hpp"

namespace tdbd::sweep {

/// Returns which rows are not dominated by any other row (Pareto front). A row dominates another if
/// it is as good in every goal and better in one. `rows`: a value for each goal, in the design's
/// order; rows with values that are not finite are never on the front. 1: on the front.
std::vector<char> front_of(const std::vector<std::vector<double>>& rows,
                           const std::vector<Goal>& goals);

/// A factor in the table: numbers in one unit, or texts.
struct FactorColumn {
  std::string key, unit;
  bool numbers = false;
};

/// All points of a design with their results, in the order of the design.
struct Table {
  const Design* design = nullptr;
  std::vector<FactorColumn> factors;
  std::vector<std::vector<Level>> levels;  ///< of each point
  std::vector<const PointRecord*> points;  ///< null: not completed
  std::vector<char> on_front;              ///< for a design with goals: not dominated
  bool states_steadiness = false;          ///< a point states whether its means are steady
  Judged judged;                           ///< for a design with a filter
  const PointRecord* unchanged =
      nullptr;  ///< the case without the factors, for a design with a filter; null: not completed
};

/// Returns the table of a design with the points completed so far. The records must outlive it.
Table table_of(const Design& d, const Points& points, const std::vector<std::string>& keys,
               const PointRecords& records, const Judged& judged = {});

/// The number of completed points, successful or failed; and the number of points to be run. Both
/// include the unchanged case of a filter.
long done_points(const Table& t);
long points_to_run(const Table& t);

/// Writes three files. NAME.nc, for xarray, has the dimension point, one variable per factor (named
/// like its key) and per figure, status, message, case_hash, and front; the goals and the text of
/// the design are attributes. The bytes depend on design and program only. NAME.csv is the same as
/// text, and NAME_timing.csv has the seconds of each point. A design with a filter also has
/// NAME_filter.csv (filter_csv). If points state whether their means are steady, the table has a
/// column `steady`. All are written to a folder of this
/// process on the same disk and then moved, because shards that end at the same time may all write
/// the table. Throws RunError.
void write_table(const std::filesystem::path& netcdf_file, const Table& t,
                 const std::filesystem::path& own_folder);

/// Writes NAME.nc only, completely or not at all. Throws RunError.
void write_netcdf(const std::filesystem::path& file, const Table& t);

/// Returns the text of NAME.csv.
std::string to_csv(const Table& t);

}  // namespace tdbd::sweep
