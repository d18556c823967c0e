#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "simulation/result/record.hpp"

namespace tdbd::simulation {

/// Rows kept in memory until they are written as one block, a whole number of the file's chunks.
inline constexpr std::size_t record_block = 512, record_chunk = 64;
static_assert(record_block % record_chunk == 0);

/// The NetCDF half of a Record: one open file and the block not yet written.
class RecordNetcdf {
 public:
  /// Creates the file and defines its dimensions and variables. Throws RunError, and std::bad_alloc, like the others.
  RecordNetcdf(const std::filesystem::path& file, const RecordLayout& layout);
  ~RecordNetcdf();  ///< closes the file, where that is safe; close() reports errors
  RecordNetcdf(const RecordNetcdf&) = delete;
  RecordNetcdf& operator=(const RecordNetcdf&) = delete;

  void append(std::span<const double> row);
  void close();

 private:
  /// A variable and its part of the block.
  struct Column {
    int variable = -1;
    std::size_t width = 1;
    std::vector<double> waiting;
  };

  void require(int status) const;
  void define(const RecordLayout& layout);
  int define_number(const RecordColumn& column, const std::vector<int>& dims, std::size_t width);
  int define_labels(const RecordLabels& labels, int dim);
  void describe(int variable, const std::string& units, const std::string& long_name);
  void write_block();
  void close_file();

  std::filesystem::path file_;
  Storage storage_;
  std::size_t memory_;  ///< that must be left before a call, bytes
  std::vector<Column> columns_;
  std::size_t written_ = 0;  ///< rows in the file
  std::size_t waiting_ = 0;  ///< rows in the block
  int nc_ = -1;
};

}  // namespace tdbd::simulation
