#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// What a cutter has when the table's optional columns are absent. SI.
struct CutterDefaults {
  double chamfer = 0.4e-3;                     ///< m, width along the face; 0: sharp
  double chamfer_angle = 0.78539816339744831;  ///< rad, from the cutter's axis; 45 deg
  double length = 13e-3;                       ///< m
  double table_thickness = 2e-3;               ///< m
  double land = 0.0;                           ///< m, width of a second chamfer inside the first
  double land_angle = 70.0 * (std::numbers::pi / 180.0);  ///< rad, from the cutter's axis
};

/// Gives a cutter the defaults.
void take_shape(Cutter& c, const CutterDefaults& d);

/// Reads a cutter table: CSV with one header line; blank lines and lines that start with '#' are
/// skipped. Required columns: bit, cutter, blade, zone, dia_mm, r_tip_mm, phi_deg, h_tip_mm,
/// profile_angle_deg, back_rake_deg, side_rake_deg; optional, in place of the defaults: chamfer_mm,
/// chamfer_deg, length_mm, table_mm, land_mm, land_deg; and wear_mm, under_exposure_mm, 0 without.
/// The columns may come in any order. under_exposure_mm tells how far a back-up's tip stands inside
/// the profile; the tip's place already has it. How far cutters stand out of their blades belongs
/// to the blades: a column `exposure...` is refused.
/// Returns the cutters in the table's order, in SI units, each with its pose.
/// Throws InputError that lists every mistake, a line each: "file:line: column: found X, expected
/// Y". Thesis: 3.2.2 (what places a cutter).
std::vector<Cutter> read_cutter_table(const std::string& csv_path, const CutterDefaults& d);

}  // namespace tdbd::bit
