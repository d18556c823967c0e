#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tdbd::simulation {

/// A dimension of a record beside time: "xyz" with x, y, z; "cone" with 1, 2, 3. May be empty.
struct RecordAxis {
  std::string name;
  std::vector<std::string> components;  ///< suffixes of the columns in the csv
};

/// Whether a column goes into the csv too.
enum class InCsv { yes, no };

/// What a number of a row says of the time since the last row: a cell method of the CF conventions.
enum class Over { point, mean, sum, minimum, maximum };

/// How a number is kept in the NetCDF file.
enum class Precision { full, single };

/// One variable: a number a row, or one for each component of an axis.
struct RecordColumn {
  std::string name;
  std::string units;  ///< as UDUNITS reads them; "1" for counts
  std::string long_name;
  int axis = -1;  ///< place in RecordLayout::axes; -1: one number a row
  InCsv csv = InCsv::yes;
  Over over = Over::point;
  Precision precision = Precision::full;
};

/// Texts along an axis, written once: names of parts.
struct RecordLabels {
  std::string name;
  std::string long_name;
  int axis = 0;
  std::vector<std::string> texts;
};

/// Whether the numbers of the NetCDF file are deflated: worth it where rows are few and long.
enum class Storage { plain, deflated };

/// What the files of a record hold. The first column is time.
struct RecordLayout {
  std::vector<RecordAxis> axes;
  std::vector<RecordColumn> columns;
  std::vector<RecordLabels> labels;
  Storage storage = Storage::plain;

  /// How many numbers a column has in a row.
  std::size_t width(const RecordColumn& c) const;
  /// How many numbers a row has.
  std::size_t row_width() const;
};

/// Records rows of numbers as NetCDF-4 (dimensions time and the axes, every variable with units and
/// long_name, and cell_methods unless it is of the row's time) and as csv beside it, its
/// columns flat. Rows are written in blocks, so that one costs
/// microseconds. Nothing in the files depends on when they were written.
class Record {
 public:
  /// Creates `path.partial`. Throws RunError when it cannot.
  Record(const std::filesystem::path& path, const RecordLayout& layout);

  /// Without close(), the NetCDF file stays as `.partial` with the blocks written so far; no csv.
  ~Record();
  Record(const Record&) = delete;
  Record& operator=(const Record&) = delete;

  /// The numbers of all columns one after another. Throws RunError when a block cannot be written,
  /// or the row does not have the layout's number.
  void append(std::span<const double> row);

  /// Writes what is buffered and gives the files their names. An interrupted run closes too.
  /// Throws RunError.
  void close();

 private:
  struct Files;
  std::unique_ptr<Files> files_;
};

}  // namespace tdbd::simulation
