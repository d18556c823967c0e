#pragma once

#include <string>
#include <vector>

namespace tdbd::bit {

/// One line of a comma-separated file, its cells trimmed of white space.
struct CsvRow {
  int line = 0;  ///< counted from 1, as editors do
  std::vector<std::string> cells;
};

/// The rows of a comma-separated text file; blank lines and lines that start with '#' are skipped.
/// No quoting: no cell holds a comma. Throws InputError when the file cannot be read.
std::vector<CsvRow> read_csv(const std::string& path);

}  // namespace tdbd::bit
