#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sweep/design/points.hpp"
#include "sweep/table/journal.hpp"

namespace tdbd::sweep {

/// A factor in the table: numbers in one unit, or texts.
struct FactorColumn {
  std::string key, unit;
  bool numbers = false;
};

/// All points of a design with what they came to, in the order of the design.
struct Table {
  const Design* design = nullptr;
  std::vector<FactorColumn> factors;
  std::vector<std::vector<Level>> levels;  ///< of each point
  std::vector<const PointRecord*> points;  ///< null: not done yet
  std::vector<char> on_front;              ///< of a design with goals: not dominated
};

/// The table of a design as far as its points are done; the records must outlive it.
Table table_of(const Design& d, const Points& points, const std::vector<std::string>& keys,
               const PointRecords& records);

/// Points that are done, of either status.
long done_points(const Table& t);

/// NAME.nc for xarray: dimension point; one variable for each factor (under its key) and each
/// figure, status, message, case_hash, and front; the design's goals and text as attributes. The
/// bytes depend on design and program alone. NAME.csv the same as text, NAME_timing.csv the seconds
/// of each point. Throws RunError.
void write_table(const std::filesystem::path& netcdf_file, const Table& t);

/// The text of NAME.csv.
std::string to_csv(const Table& t);

}  // namespace tdbd::sweep
