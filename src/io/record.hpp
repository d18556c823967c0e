#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tdbd {

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

/// Rows kept in memory until they are written as one block, a whole number of the file's chunks.
inline constexpr std::size_t record_block = 512, record_chunk = 64;
static_assert(record_block % record_chunk == 0);

/// Whether a record has a csv file beside its NetCDF file.
enum class CsvBeside { yes, no };

/// Records rows of numbers as NetCDF-4 (dimensions time and the axes, every variable with units and
/// long_name, and cell_methods unless it is of the row's time) and as csv beside it, its columns
/// flat. Rows are written in blocks, so that one takes microseconds. Nothing in the files depends on
/// when they were written.
class Record {
 public:
  /// Creates `path.partial`. Throws RunError when it cannot.
  Record(const std::filesystem::path& path, const RecordLayout& layout,
         CsvBeside csv = CsvBeside::yes);

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

/// Rows of numbers as a run makes them, one after another in a file that is readable after a kill.
/// A resumed run makes its record again from them: a NetCDF file that was not closed is lost.
class RowLog {
 public:
  /// Opens the file, made if there is none, and discards all rows but the first `kept`. Throws
  /// RunError; also if there are fewer.
  RowLog(std::filesystem::path path, std::size_t width, long kept);

  /// Calls visit(row) for the rows that were kept.
  void replay(const std::function<void(std::span<const double>)>& visit);

  void append(std::span<const double> row);
  /// Forces all rows to the disk.
  void sync();
  long rows() const { return rows_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void require(bool is_done) const;

  std::filesystem::path path_;
  std::size_t width_;
  long rows_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace tdbd
