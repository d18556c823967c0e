#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/angles.hpp"

namespace tdbd::bit {

/// The shape of cutters whose table has no columns for it. SI.
struct CutterDefaults {
  double chamfer = 0.0;                      ///< m, width along the face; 0: sharp
  double chamfer_angle = 0.5 * right_angle;  ///< rad, from the cutter's axis
  double length = 13e-3;                     ///< m
  double table_thickness = 2e-3;             ///< m
  double land = 0.0;                         ///< m, width of a second chamfer inside the first
  double land_angle = 70.0 * degree;         ///< rad, from the cutter's axis
};

/// Gives a cutter the default shape.
void take_shape(Cutter& c, const CutterDefaults& d);

/// Reads a cutter table: CSV with one header line. Blank lines and lines that start with '#' are
/// skipped. Required columns: bit, cutter, blade, zone, dia_mm, r_tip_mm, phi_deg, h_tip_mm,
/// profile_angle_deg, back_rake_deg, side_rake_deg; optional, in place of the defaults: chamfer_mm,
/// chamfer_deg, length_mm, table_mm, land_mm, land_deg; and wear_mm, under_exposure_mm, 0 without.
/// The columns may come in any order. under_exposure_mm says how far a back-up's tip stands inside
/// the profile; the tip's place already includes it. How far cutters stand out of their blades is a
/// property of the blades: a column `exposure...` is refused. Returns the cutters in the table's
/// order, in SI units, each with its pose. Throws InputError that lists every mistake, one line
/// each: "file:line: column: found X, expected Y". Thesis: 3.2.2 (what places a cutter).
std::vector<Cutter> read_cutter_table(const std::string& csv_path, const CutterDefaults& d);

/// The cutters as a table with every column, which read_cutter_table reads back to the same values
/// to the last bit, if they came from a table with these columns or from a generator. `bit` fills
/// the first column.
std::string cutter_table_text(const std::string& bit, const std::vector<Cutter>& cutters);

/// Rounds a cutter's numbers to those that a table can hold: writing and reading changes no bit.
void round_to_table(Cutter& c);

}  // namespace tdbd::bit
