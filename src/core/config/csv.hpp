#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tdbd {

/// One line of a table: its cells as text, without surrounding blanks.
struct CsvRow {
  long line = 0;  ///< counted from 1
  std::vector<std::string> cells;
};

/// Reads the rows of a file by RFC 4180: a cell in double quotes may contain separators, line ends
/// and, doubled, quotes. The separator is that of a first line "sep=;", otherwise the most frequent
/// one in the header: a comma, a semicolon or a tab. With the latter two, numbers may have a decimal
/// comma ("50,5" is returned as "50.5"), unless other numbers have a point. Lines that are empty,
/// have only empty cells, or start with '#' are skipped, and so are empty cells behind the last
/// column with a name. Line ends are LF, CRLF or CR. The text is UTF-8 or, with a byte-order mark,
/// UTF-16. Throws InputError if the file cannot be read, is a workbook (xlsx, xls), has a byte that
/// is no UTF-8 (the message names line and byte), or a quote that is not closed.
std::vector<CsvRow> read_csv_rows(const std::string& path);

/// Returns the finite number that fills the whole cell; otherwise nothing.
template <typename Number>
std::optional<Number> csv_number(const std::string& cell) {
  Number value{};
  const char* end = cell.data() + cell.size();
  const auto [rest, error] = std::from_chars(cell.data(), end, value);
  if (error != std::errc() || rest != end || !std::isfinite(static_cast<double>(value)))
    return std::nullopt;
  return value;
}

/// What to add to "a number" in the message about a cell that contains a comma; otherwise empty.
std::string comma_hint(std::string_view cell);

/// A name of a column and its unit.
struct NamedUnit {
  std::string name, unit;
};

/// Splits "hook load [kN]" or "hook load (kN)"; without brackets the unit is empty.
NamedUnit split_unit(std::string_view text);

/// The mistakes of one file, in the order in which they were found.
struct CsvMistakes {
  std::string file;
  std::vector<std::string> lines = {};  ///< "FILE:LINE: COLUMN: found F, expected E"

  void add(long line, std::string_view column, std::string_view found, std::string_view expected);
  /// Throws InputError with one line for each; of more than 40, the first ones and their number.
  void throw_if_any() const;
};

/// Throws InputError with one mistake, "FILE:LINE: WHAT: found F, expected E".
[[noreturn]] void refuse_table(const std::string& file, long line, std::string_view what,
                               std::string_view found, std::string_view expected);

/// A table of numbers with named columns. All rows have as many values as there are columns.
struct CsvTable {
  std::string file;                       ///< as given, for messages
  std::vector<std::string> header;        ///< names of the columns, all different
  std::vector<std::vector<double>> rows;  ///< finite numbers
  std::vector<long> lines;                ///< line of the file of each row
};

/// Reads a file of comma-separated numbers with a header line. Throws InputError that lists all
/// mistakes (CsvMistakes).
CsvTable read_csv(const std::string& path);

/// Returns the index of the column with this name; if there is none, that of the first one with this
/// name in other case. Throws InputError that suggests the nearest name.
std::size_t csv_column(const CsvTable& table, std::string_view name);

/// A record of measurements written by a rig: named columns with units. Cells may be empty.
struct FieldTable {
  std::string file;                ///< as given, for messages
  std::vector<std::string> names;  ///< of the columns
  std::vector<std::string> units;  ///< of the columns; empty if the file states none
  std::vector<CsvRow> rows;        ///< each with as many cells as there are columns
  double null = -999.25;           ///< the number that means "no value"
};

/// Reads LAS 2.0 if the name of the file ends in ".las" (any case), otherwise comma-separated
/// values with a header of names and units such as "hook load [kN]" or "hook load (kN)". LAS: reads
/// the sections ~Version (WRAP NO), ~Well (NULL), ~Curve and ~A. Throws InputError.
FieldTable read_field_table(const std::string& path);

/// Returns a column in SI units. `column`: "HKLA", or "HKLA [kN]" with a unit that replaces the
/// file's. Upper and lower case are the same if no name is equal. Throws InputError if there is no such column (the message lists those of the file), no
/// unit, a unit of another dimension, or a row without a value: an empty cell, a text, NaN or the
/// null value.
std::vector<double> field_column(const FieldTable& table, std::string_view column,
                                 const std::string& si_unit);

}  // namespace tdbd
