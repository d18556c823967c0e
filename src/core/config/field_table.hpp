#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/config/csv.hpp"

namespace tdbd {

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
/// file's. Throws InputError if there is no such column (the message lists those of the file), no
/// unit, a unit of another dimension, or a row without a value: an empty cell, a text, NaN or the
/// null value.
std::vector<double> field_column(const FieldTable& table, std::string_view column,
                                 const std::string& si_unit);

}  // namespace tdbd
