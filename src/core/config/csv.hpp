#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tdbd {

/// One line of a comma-separated file: its cells as text, without the blanks around them. No
/// quoting: no cell holds a comma.
struct CsvRow {
  long line = 0;  ///< counted from 1
  std::vector<std::string> cells;
};

/// The rows of a file. Lines that are empty or start with '#' are left out; a byte-order mark and
/// CRLF are tolerated. Throws InputError when the file cannot be read.
std::vector<CsvRow> read_csv_rows(const std::string& path);

/// The finite number that fills a whole cell; nothing otherwise.
template <typename Number>
std::optional<Number> csv_number(const std::string& cell) {
  Number value{};
  const char* end = cell.data() + cell.size();
  const auto [rest, error] = std::from_chars(cell.data(), end, value);
  if (error != std::errc() || rest != end || !std::isfinite(static_cast<double>(value)))
    return std::nullopt;
  return value;
}

/// The mistakes of one file, in the order in which they were found.
struct CsvMistakes {
  std::string file;
  std::vector<std::string> lines = {};  ///< "FILE:LINE: COLUMN: found F, expected E"

  void add(long line, std::string_view column, std::string_view found, std::string_view expected);
  void throw_if_any() const;  ///< InputError that lists them all, a line each
};

/// A table of numbers with named columns. Every row has as many values as the header has names.
struct CsvTable {
  std::string file;                       ///< as given, for messages
  std::vector<std::string> header;        ///< names of the columns, all different
  std::vector<std::vector<double>> rows;  ///< finite numbers
  std::vector<long> lines;                ///< line of the file that each row stands on
};

/// Reads a file of comma-separated numbers under a header line. Throws InputError that lists all
/// mistakes (CsvMistakes).
CsvTable read_csv(const std::string& path);

/// Place of the column with this name. Throws InputError that names the nearest one.
std::size_t csv_column(const CsvTable& table, std::string_view name);

}  // namespace tdbd
