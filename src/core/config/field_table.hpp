#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/config/csv.hpp"

namespace tdbd {

/// A record of measurements as a rig writes it: named columns with units, some of whose cells are empty.
struct FieldTable {
  std::string file;                ///< as given, for messages
  std::vector<std::string> names;  ///< of the columns
  std::vector<std::string> units;  ///< as many; empty where the file states none
  std::vector<CsvRow> rows;        ///< as many cells each
  double null = -999.25;           ///< the number that stands for no value
};

/// Reads LAS 2.0 where the name of the file ends in ".las" (any case), otherwise comma-separated values
/// under a header of names, each with its unit as in "hook load [kN]" or "hook load (kN)". LAS: sections
/// ~Version (WRAP NO), ~Well (NULL), ~Curve and ~A are read. Throws InputError.
FieldTable read_field_table(const std::string& path);

/// A column in SI units: "HKLA", or "HKLA [kN]" with the unit to use in place of the file's. Throws
/// InputError: no such column (lists those of the file), no unit, one of another dimension, or a row
/// without a value: an empty cell, a text, NaN or the null value.
std::vector<double> field_column(const FieldTable& table, std::string_view column,
                                 const std::string& si_unit);

}  // namespace tdbd
