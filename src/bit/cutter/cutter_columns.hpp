#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bit/bit.hpp"
#include "core/config/csv.hpp"
#include "core/config/key_table.hpp"

namespace tdbd::bit {

/// A column that contains a number: its destination, unit and valid range. A table may give it in
/// another unit of the same dimension: "r_tip_in" instead of "r_tip_mm".
struct NumberColumn {
  std::string_view base;  ///< name without the unit: "r_tip"
  std::string_view unit_name;
  double Cutter::*member;
  double unit;  ///< SI per usual unit of the column
  bool required;
  double lowest, highest;     ///< in the usual unit
  std::string_view expected;  ///< the lower bound in words, for messages
  std::string_view fallback;  ///< the default in words; empty: required
  std::string_view meaning;

  std::string name() const { return std::string(base) + "_" + std::string(unit_name); }
};

/// The columns of numbers, in the order in which tables are written.
const std::vector<NumberColumn>& number_columns();

/// Where the columns of a table are, and their units.
struct CutterColumns {
  struct Number {
    const NumberColumn* column = nullptr;
    std::string name;  ///< as in the header, in lower case
    std::size_t cell = 0;
    double unit = 0.0;  ///< SI per unit of the cells
  };
  std::map<std::string, std::size_t, std::less<>> labels;  ///< cells of bit, cutter, blade, zone
  std::vector<Number> numbers;                             ///< in the order of number_columns()
};

/// Reads the header of a cutter table. Upper and lower case are the same, and so are "R tip [mm]"
/// and "r_tip_mm". Units of lengths: mm, cm, m, in; of angles: deg, rad. Columns named note, notes,
/// comment, comments, remark or remarks are ignored. Adds a mistake for each column that is
/// unknown (with the nearest name), has no unit or an unknown one, occurs twice, or is missing.
CutterColumns read_cutter_columns(const CsvRow& header, CsvMistakes& mistakes);

/// What a reader of the list of columns needs to know about the file.
inline constexpr const char* cutter_table_notes =
    "The file is CSV with a header line and one row for each cutter; columns may be in any order.\n"
    "Units are at the end of the names: _mm, _cm, _m, _in; _deg, _rad (r_tip_in, phi_rad). Upper "
    "and\n"
    "lower case are the same. Separators are commas, semicolons or tabs; with the latter two also\n"
    "decimal commas. Lines with # and blank rows are skipped. Columns named note, notes, comment "
    "or\n"
    "remark are ignored. Save a workbook (xlsx) as \"CSV UTF-8\". `tdbd new bit NAME` writes an "
    "example.\n";

/// The columns as a table of keys, for `tdbd keys cutter-table`.
KeyTable cutter_table_keys();

}  // namespace tdbd::bit
