#pragma once

#include <array>
#include <string>
#include <vector>

#include "bit/cutter/cutter_table.hpp"

namespace tdbd::bit {

/// Design parameters of a bit's profile: a straight cone, the nose's arc, the shoulder's arc,
/// tangent to the nose and to the gage, and the gage; bit (3) and (4). SI. Not in the thesis.
struct ProfileDesign {
  double gage_radius = 0.0;
  double cone_angle = 0.0;      ///< rad, of the cone's line above the horizontal
  double nose_place = 0.0;      ///< m, radius at which the profile is lowest
  double nose_radius = 0.0;     ///< m, of the nose's arc
  double shoulder_angle = 0.0;  ///< rad, profile angle at which the shoulder's arc begins
  double gage_length = 0.0;     ///< m, along the axis
};

/// The pieces of the profile, from the axis to the gage's upper end.
enum class Region { cone, nose, shoulder, gage };

/// A point of the profile.
struct ProfileSpot {
  double r = 0.0;      ///< m, from the axis
  double h = 0.0;      ///< m, above the lowest point
  double angle = 0.0;  ///< rad, of the normal into the rock: (sin, cos) in (r, z), z down
  Region region = Region::cone;
};

/// Radius of the shoulder's arc, m, which is tangent to nose and gage, bit (3); <= 0 if the profile
/// folds.
double shoulder_radius(const ProfileDesign& p);

/// The shoulder_angle (rad) for a shoulder of this radius (m), the alternative parameter of a
/// profile. NaN if there is none.
double shoulder_angle_for(const ProfileDesign& p, double radius);

/// Arc lengths, m, from the axis to the end of each region.
std::array<double, 4> region_ends(const ProfileDesign& p);

/// The point at the arc length s (m) from the axis, 0 <= s <= the end of the gage; bit (4).
ProfileSpot spot_at(const ProfileDesign& p, double s);

/// A quantity that varies along the profile: its values on the axis and at the beginnings of nose,
/// shoulder and gage. It is linear in arc length between them and constant along the gage.
struct RegionLaw {
  double axis = 0.0;
  double nose = 0.0;
  double shoulder = 0.0;
  double gage = 0.0;
};

/// A quantity with one value in each region.
struct RegionChoice {
  double cone = 0.0;
  double nose = 0.0;
  double shoulder = 0.0;
  double gage = 0.0;
};

/// Whether a blade carries back-up cutters.
enum class Backups { none, behind_face_cutters };

/// Design parameters of one blade.
struct BladeDesign {
  double azimuth = 0.0;  ///< rad, on the bit's axis
  double start = 0.0;    ///< m, smallest radius at which the blade carries cutters
  Backups backups = Backups::none;
};

/// Back-up cutters: behind the face cutters of a blade, at the same place of the profile but moved
/// back from it.
struct BackupRow {
  double from = 0.0;               ///< m, smallest radius of the face cutters that have one
  double to = 1e3;                 ///< m, largest radius
  double under_exposure = 1.5e-3;  ///< m, from the profile into the bit
  double behind = 20e-3;           ///< m, from face to face along the circle about the axis
};

/// The cutters on the gage of every blade.
struct GageRow {
  int cutters = 1;       ///< on each blade
  double start = 1.1;    ///< diameters, from the gage's lower end to the first cutter
  double spacing = 1.1;  ///< diameters
};

/// Design parameters of a PDC bit. SI. Thesis: 3.2.2, app. A; the rules are not in the thesis.
struct PdcDesign {
  static constexpr double usual_clearance = 5e-4;  // m

  ProfileDesign profile;
  std::vector<BladeDesign> blades;
  double first_radius = 0.0;           ///< m, of the tip nearest to the axis
  double spiral = 0.0;                 ///< rad, by which a blade trails at the gage
  double clearance = usual_clearance;  ///< m, smallest gap between the solids of two cutters
  RegionChoice diameter;               ///< m
  RegionLaw overlap;    ///< smallest overlap of neighbours on the profile over a diameter
  RegionLaw back_rake;  ///< rad
  RegionLaw side_rake;  ///< rad
  RegionLaw wear;       ///< m, height of the wear flat
  BackupRow backups;
  GageRow gage;
  CutterDefaults shape;  ///< chamfer, length and table of every cutter
};

/// A mistake of a design: the key in the bit file, its value, and what is expected.
struct DesignProblem {
  std::string key;
  std::string found;
  std::string expected;
};

/// Returns what makes a design impossible before any cutter is placed: sizes that are not positive,
/// a profile that folds, a nose outside the gage, overlaps that leave no spacing.
std::vector<DesignProblem> design_problems(const PdcDesign& d);

/// The value of a law at the arc length s (m) of a profile.
double law_at(const RegionLaw& law, const ProfileDesign& p, double s);

/// The value of a choice in a region.
double choice_in(const RegionChoice& choice, Region region);

}  // namespace tdbd::bit
