#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tdbd {

/// A dimension of a record besides time: "xyz" with x, y, z; "cone" with 1, 2, 3. May be empty.
struct RecordAxis {
  std::string name;
  std::vector<std::string> components;  ///< suffixes of the columns in the csv
};

/// Whether a column is also written to the csv.
enum class InCsv { yes, no };

/// How a number in a row represents the time since the previous row: a cell method of the CF
/// conventions.
enum class Over { point, mean, sum, minimum, maximum };

/// The precision with which a number is stored in the NetCDF file.
enum class Precision { full, single };

/// One variable: one number per row, or one per component of an axis.
struct RecordColumn {
  std::string name;
  std::string units;  ///< in the syntax of UDUNITS; "1" for counts
  std::string long_name;
  int axis = -1;  ///< index in RecordLayout::axes; -1: one number per row
  InCsv csv = InCsv::yes;
  Over over = Over::point;
  Precision precision = Precision::full;
};

/// Texts along an axis, such as names of parts. They are written once.
struct RecordLabels {
  std::string name;
  std::string long_name;
  int axis = 0;
  std::vector<std::string> texts;
};

/// Whether the NetCDF file is compressed (deflate). This is worthwhile if rows are few and long.
enum class Storage { plain, deflated };

/// The contents of a record's files. The first column is time.
struct RecordLayout {
  std::vector<RecordAxis> axes;
  std::vector<RecordColumn> columns;
  std::vector<RecordLabels> labels;
  Storage storage = Storage::plain;

  /// Number of values of a column in a row.
  std::size_t width(const RecordColumn& c) const;
  /// Number of values in a row.
  std::size_t row_width() const;
};

/// Rows in memory before they are written as one block, a multiple of the chunk size of the file.
inline constexpr std::size_t record_block = 512, record_chunk = 64;
static_assert(record_block % record_chunk == 0);

/// Whether a record has a csv file in addition to its NetCDF file.
enum class CsvBeside { yes, no };

/// Records rows of numbers as NetCDF-4 and as csv. The NetCDF file has the dimensions time and the
/// axes; every variable has units and long_name, and cell_methods unless its values are those at
/// the row's time. The csv has one column per component. Rows are written in blocks, so that
/// appending one takes microseconds. The files do not depend on the time of writing.
class Record {
 public:
  /// Creates `path.partial`. Throws RunError if it cannot be created.
  Record(const std::filesystem::path& path, const RecordLayout& layout,
         CsvBeside csv = CsvBeside::yes);

  /// Without close(), the NetCDF file remains as `.partial` with the blocks written so far, without
  /// a csv.
  ~Record();
  Record(const Record&) = delete;
  Record& operator=(const Record&) = delete;

  /// Appends the numbers of all columns in order. Throws RunError if a block cannot be written or
  /// if the number of values is not that of the layout.
  void append(std::span<const double> row);

  /// Writes what is buffered and renames the files to their final names. Also used for interrupted
  /// runs. Throws RunError.
  void close();

 private:
  struct Files;
  std::unique_ptr<Files> files_;
};

/// A log of a run's rows, one after another, in a file that can be read after the process was
/// killed. A resumed run writes its record again from this log, because a NetCDF file that was not
/// closed is unreadable.
class RowLog {
 public:
  /// Opens or creates the file and discards all rows but the first `kept`. Throws RunError, also if
  /// there are fewer rows.
  RowLog(std::filesystem::path path, std::size_t width, long kept);

  /// Calls visit(row) for every kept row.
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
