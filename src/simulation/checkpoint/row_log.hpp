#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>

namespace tdbd::simulation {

/// Rows of numbers as a run makes them, one after another in a file that a kill leaves readable. A
/// run that goes on makes its record anew from them: a NetCDF file that was not closed is lost.
class RowLog {
 public:
  /// Opens the file, made if there is none, and forgets all rows but the first `kept`. Throws
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

}  // namespace tdbd::simulation
