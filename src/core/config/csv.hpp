#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tdbd {

/// One line of a file of comma-separated texts, without white space around them. No quoting: no cell
/// holds a comma.
struct CsvRow {
  int line = 0;  ///< of the file, counted from 1
  std::vector<std::string> cells;
};

/// Reads the lines of a file, the header among them. Lines that are empty or start with '#' are left
/// out; a byte-order mark and CRLF are tolerated. Throws InputError when there is no such file.
std::vector<CsvRow> read_csv_rows(const std::string& path);

/// A table of numbers with named columns. Every row has as many values as the header has names.
struct CsvTable {
  std::string file;                       ///< as given, for messages
  std::vector<std::string> header;        ///< names of the columns, all different
  std::vector<std::vector<double>> rows;  ///< finite numbers
  std::vector<long> lines;                ///< line of the file that each row stands on
};

/// Reads a file of comma-separated numbers under a header line (read_csv_rows). Throws InputError
/// that lists all mistakes, one line each: "FILE:LINE: COLUMN: found F, expected E".
CsvTable read_csv(const std::string& path);

/// Place of the column with this name. Throws InputError that names the nearest one.
std::size_t csv_column(const CsvTable& table, std::string_view name);

}  // namespace tdbd
