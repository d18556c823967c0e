#pragma once

#include <string>
#include <vector>

#include "calibration/record/record.hpp"

namespace tdbd::calibration {

/// The records of one file, all of bits or all of single cutters.
struct Records {
  std::string file;
  ToolKind kind = ToolKind::bit;
  std::vector<Record> rows;
};

/// Reads a csv file whose header has "name [unit]" in each cell, in any order:
///   bits     test, bit, pressure, rotary_speed, rate_of_penetration, wob;
///            tob, wob_sd, tob_sd, rock
///   cutters  test, cutter, speed, depth, normal; pressure, drag, normal_sd, drag_sd, rock
/// Columns after the semicolon are optional. A load may be empty if it was not read. Throws
/// InputError that lists all mistakes: unknown or missing column, wrong unit, no number, a value
/// out of range, a duplicate row.
Records read_records(const std::string& path);

}  // namespace tdbd::calibration
