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
///   agrees with their profile angles. Names the column whose correction makes
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

/// A cutter's tip on the profile: m, rad.
struct ProfileTip {
  double r = 0.0, h = 0.0, angle = 0.0, diameter = 0.0;
  std::size_t index = 0;  ///< of the cutter
};

/// The face cutters (without under-exposure) along the profile, from the axis to the gage. They are
/// sorted by r + h, which increases along any profile whose cone is flatter than 45 degrees.
std::vector<ProfileTip> tips_along_profile(const std::vector<Cutter>& cutters);

/// How badly a tip fits its neighbours; at most 1 is usual.
struct Misfit {
  double place = 0.0, angle = 0.0;
  double worst() const { return place > angle ? place : angle; }
};

/// Compares a tip with its two nearest neighbours. On a smooth profile, the chord between two tips
/// has the mean of their profile angles, exactly on a circle. `place`: distance of the tip from
/// that chord over a tolerance of 0.4 mm and a quarter of the bend; the better neighbour counts, so
/// that a wrong neighbour has no effect. `angle`: difference of the profile angle from that of the
/// neighbours, or of the chords, whichever is less, over a tolerance of 3.5 degrees.
Misfit misfit_at(const std::vector<ProfileTip>& tips, std::size_t i);

/// Number of tips that do not fit.
std::size_t misfits(const std::vector<ProfileTip>& tips);

/// Names the cutters that do not fit, the worst first; each is left out before the next is sought.
std::vector<TableDoubt> profile_doubts(const std::vector<Cutter>& cutters);

/// Doubts about tables in which at least two tips have negative heights, fewer than half of all, and
/// with positive ones lie on the profile: one for each of these tips, and those of profile_doubts
/// about the table with positive heights. Otherwise empty. Such rows fit each other and therefore
/// would make the rows between them look wrong.
std::vector<TableDoubt> height_sign_doubts(const std::vector<Cutter>& cutters);

}  // namespace tdbd::bit
