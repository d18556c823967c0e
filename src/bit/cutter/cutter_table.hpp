#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/types.hpp"

namespace tdbd::bit {

/// Shape of cutters whose table does not have columns for it. SI.
struct CutterDefaults {
  double chamfer = 0.0;                      ///< m, width along the face; 0: sharp
  double chamfer_angle = 0.5 * right_angle;  ///< rad, from the cutter's axis
  double length = 13e-3;                     ///< m
  double table_thickness = 2e-3;             ///< m
  double land = 0.0;                         ///< m, width of a second chamfer inside the first
  double land_angle = 70.0 * degree;         ///< rad, from the cutter's axis
};

/// Sets a cutter's shape to the default.
void take_shape(Cutter& c, const CutterDefaults& d);

/// Reads a cutter table: CSV with one header line (core/config/csv.hpp). Columns may be in any order
/// and in other units (cutter_columns.hpp; `tdbd keys cutter-table` lists them).
///   required: cutter, blade, zone, dia_mm, r_tip_mm, phi_deg, h_tip_mm, profile_angle_deg,
///             back_rake_deg, side_rake_deg
///   optional, default as in `d`: chamfer_mm, chamfer_deg, length_mm, table_mm, land_mm, land_deg
///   optional, default 0: wear_mm, under_exposure_mm
///   optional, not used: bit, note
/// under_exposure_mm is the distance of a back-up's tip inside the profile; the position of the tip
/// already includes it. The exposure of cutters above their blades is a property of the blades: a
/// column `exposure...` is rejected. Returns the cutters in the table's order, in SI units, each
/// with its pose. Throws InputError that lists every mistake, one per line: "file:line: column:
/// found X, expected Y". Thesis: 3.2.2 (the quantities that place a cutter).
std::vector<Cutter> read_cutter_table(const std::string& csv_path, const CutterDefaults& d);

/// Returns the cutters as a table with every column, with the shortest numbers that give the same
/// values. read_cutter_table reads bitwise identical
/// values back if the cutters came from a table with these columns or from a generator. `bit`:
/// value of the first column.
std::string cutter_table_text(const std::string& bit, const std::vector<Cutter>& cutters);

/// Rounds a cutter's values to those that a table can represent, so that writing and reading is
/// lossless.
void round_to_table(Cutter& c);

}  // namespace tdbd::bit
