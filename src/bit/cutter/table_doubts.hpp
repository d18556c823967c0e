#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Whether a value may be intended (a warning) or makes no bit (an error).
enum class Severity { doubtful, impossible };

/// A value of a cutter table that contradicts its neighbours.
struct TableDoubt {
  int line = 0;        ///< of the file
  std::string column;  ///< as in tables that TDBD writes: "h_tip_mm"
  std::string found, expected;
  Severity severity = Severity::doubtful;
};

/// Compares every cutter with its neighbours along the profile, its blade and the whole table.
/// Detects values that are legal one by one but do not fit:
/// - tip and profile angle: tips of neighbours must be connected by a smooth profile whose tangent
///   agrees with their profile angles (profile_doubts.hpp). Names the column whose correction makes
///   the cutter fit, and the value.
/// - whole columns: signs, radians, inches, diameters, swapped columns;
/// - rakes and azimuths that differ from those of the neighbours, and missing rows.
/// Back-up cutters (with under-exposure) are not compared along the profile. Of tables of less than
/// eight face cutters, and of more than 400, only the sizes are checked. Not in the thesis.
std::vector<TableDoubt> table_doubts(const std::vector<Cutter>& cutters);

/// Doubts about the unit of a whole table: bits that are too small or too large, and diameters that
/// do not fit the bit. The question names the unit that fits both: inches, cm, m or mm. Empty if
/// there are less than three cutters.
std::vector<TableDoubt> size_doubts(const std::vector<Cutter>& cutters);

/// Doubts about the unit of other lengths: columns of chamfers, lengths, tables and under-exposures
/// that are usual in inches or mm only, and rows whose diameter is far from that of the others.
std::vector<TableDoubt> feature_doubts(const std::vector<Cutter>& cutters);

/// "FILE:LINE: COLUMN: found F, expected E".
std::string doubt_text(const std::string& file, const TableDoubt& doubt);

}  // namespace tdbd::bit
