#pragma once

#include <cstddef>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

namespace tdbd {

/// NetCDF and HDF5 do not support two threads at once, not even with two files. Every function of
/// NetcdfFile locks this mutex; other code must lock it while it calls these libraries.
inline std::recursive_mutex& netcdf_mutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

using NetcdfLock = std::lock_guard<std::recursive_mutex>;

/// Another name of a file, through the descriptor of its open folder: "/proc/self/fd/7/history.nc".
/// It is needed because NetCDF interprets blanks, backslashes and colons in the names of folders.
/// The name is valid as long as the object. On systems without such names it is the path itself.
class DescriptorPath {
 public:
  explicit DescriptorPath(const std::filesystem::path& file);
  ~DescriptorPath();
  DescriptorPath(const DescriptorPath&) = delete;
  DescriptorPath& operator=(const DescriptorPath&) = delete;

  const char* c_str() const { return name_.c_str(); }

 private:
  int folder_ = -1;
  std::string name_;
};

enum class NetcdfType { real, single, whole, flag, text };

/// A variable to be defined; dims are results of NetcdfFile::dimension.
struct NetcdfVariable {
  std::string name;
  NetcdfType type = NetcdfType::real;
  std::vector<int> dims;
  std::string units;  ///< in the syntax of UDUNITS; empty: no such attribute
  std::string long_name;
};

/// How the numbers of a variable over an unlimited dimension are stored.
struct NetcdfChunks {
  std::size_t rows = 64, width = 1;
  bool deflated = false;
};

/// An open NetCDF-4 file. If the library fails, every function throws RunError, "cannot write FILE:
/// REASON" or "cannot read FILE: REASON".
class NetcdfFile {
 public:
  enum class Use { create, read };

  /// `memory`: bytes that must be available before the file is opened, rows are written, or it is
  /// closed; otherwise these throw std::bad_alloc.
  NetcdfFile(std::filesystem::path path, Use use, std::size_t memory = 8'000'000);
  /// Closes the file if that is safe. Only close() reports errors.
  ~NetcdfFile();
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;

  static constexpr int global = -1;  ///< instead of a variable, for attributes of the file

  /// `length` 0: unlimited, for rows that are appended. NetCDF does not support dimensions of
  /// length 0.
  int dimension(const std::string& name, std::size_t length);
  int variable(const NetcdfVariable& v);
  void set_chunks(int variable, const NetcdfChunks& chunks);
  void attribute(int variable, const std::string& name, const std::string& text);
  void attribute(int variable, const std::string& name, double value);
  void attribute(int variable, const std::string& name, const std::vector<signed char>& values);
  void end_definitions();

  /// Writes all values of a variable.
  void put(int variable, const std::vector<double>& values);
  void put(int variable, const std::vector<int>& values);
  void put(int variable, const std::vector<signed char>& values);
  void put(int variable, const std::vector<std::string>& texts);
  /// Writes `count` rows of `width` numbers, beginning with the row `first`.
  void put_rows(int variable, std::size_t first, std::size_t count, std::size_t width,
                const std::vector<double>& values);

  std::string text(const std::string& attribute) const;
  double number(const std::string& attribute) const;
  std::size_t length(const std::string& dimension) const;
  /// Returns all values of a variable. Their number must be `count`.
  std::vector<double> reals(const std::string& variable, std::size_t count) const;
  std::vector<int> wholes(const std::string& variable, std::size_t count) const;

  /// Writes what is buffered, forces the file to the disk and closes it.
  void close();

 private:
  void require(int status) const;
  int id_of(const std::string& variable, std::size_t count) const;

  std::filesystem::path path_;
  Use use_;
  std::size_t memory_;
  int id_ = -1;
};

}  // namespace tdbd
