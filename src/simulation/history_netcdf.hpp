#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "simulation/history.hpp"
#include "simulation/history_columns.hpp"

namespace tdbd::simulation {

/// Rows kept in memory until they are written as one block, and the chunk length of the file.
inline constexpr std::size_t history_block = 512;

/// The NetCDF half of a History: one open file and the block not yet written.
class HistoryNetcdf {
 public:
  /// Creates the file and defines its dimensions and variables. Throws RunError.
  HistoryNetcdf(const std::filesystem::path& file, const std::vector<HistoryPart>& parts);
  ~HistoryNetcdf();  ///< closes the file; errors are for close() to tell
  HistoryNetcdf(const HistoryNetcdf&) = delete;
  HistoryNetcdf& operator=(const HistoryNetcdf&) = delete;

  void append(const HistoryRow& row);
  void close();

 private:
  void require(int status) const;
  void define(const std::vector<HistoryPart>& parts);
  int define_text(const char* name, const char* long_name, int part_dim);
  int define_number(const HistoryColumn& about, const std::vector<int>& dims);
  void write_text(int variable, std::size_t part, const std::string& text);
  void write_block();

  std::filesystem::path file_;
  std::size_t part_count_ = 0;
  std::size_t written_ = 0;  ///< rows in the file
  std::size_t waiting_ = 0;  ///< rows in the block
  std::array<int, history_columns.size()> variables_{};
  std::array<std::vector<double>, history_columns.size()> columns_;
  int by_part_variable_ = -1;
  std::vector<double> by_part_;
  int nc_ = -1;
};

}  // namespace tdbd::simulation
