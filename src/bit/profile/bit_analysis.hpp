#pragma once

#include <span>
#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Indices of the cutters that analyses before drilling include: those whose face cuts when the bit
/// starts. Cutters that an area turns off, or that start later, are excluded. A cutter without a
/// face is included if one of its parts cuts.
std::vector<int> cutting_at_start(const Bit& bit);

/// Returns these cutters of a bit.
std::vector<Cutter> cutters_at(const Bit& bit, std::span<const int> indices);

/// Expands values of these cutters to all cutters; the others get `otherwise`.
std::vector<double> expand_to_all_cutters(const Bit& bit, std::span<const int> indices,
                                          std::span<const double> values, double otherwise);

/// Names of the excluded cutters: "cutter-3, cutter-5".
std::string excluded_cutter_names(const Bit& bit);

/// Width (m) of the columns in reports.
inline constexpr double report_column_width = 0.1e-3;

/// What each cutter cuts in steady drilling, in the order of the cutters, and how many cutters cut
/// at each radius.
struct Engagement {
  std::vector<double> area;    ///< m2, cut area in the (r, z) half-plane
  std::vector<double> volume;  ///< m3 per revolution
  std::vector<double> edge;    ///< m, length of the rim that cuts, in the (r, z) half-plane
  std::vector<int> cutting;    ///< per column of radius: cutters that remove rock there
  double column_width = 0.0;   ///< m; column k is centred at (k + 1/2) column_width
};

/// Classical radial-plane analysis (Warren and Sinor 1986) in closed form, bit (10). The bit turns
/// steadily and moves down by `advance` (m > 0) per revolution. Area and volume are sums of h dr
/// and 2 pi r h dr over columns of at most `column_width` (m) from the axis to the widest rim.
/// Chamfers lie inside the rim. Without cutters there are no columns.
Engagement engagement(const std::vector<Cutter>& cutters, double advance, double column_width);

/// Exposure of every cutter above its neighbours, m, with all rims rotated into one half-plane
/// (turned_outline): along the cutter's profile normal, from the envelope of the other rims to its
/// tip. Positive: the cutter protrudes and cuts by itself. Negative: others protrude beyond its
/// tip. NaN if no other rim passes within its own diameter. Two equal cutters of radius R without
/// rakes, side by side at a distance d < R on a flat profile have R - sqrt(R^2 - d^2). Not in the
/// thesis.
std::vector<double> exposures(const std::vector<Cutter>& cutters);

/// Overlap of each cutter with the next one, over their mean diameter, when all are rotated into
/// one half-plane, in ascending order of radius, then height. Negative if tips are farther apart
/// than a diameter. NaN for the last cutter and for back-ups, which are omitted.
std::vector<double> overlaps(const std::vector<Cutter>& cutters);

/// Imbalance under the unit law: every cutter pushes along its profile normal with its area, at 1
/// Pa. Returns the lateral resultant over the sum of the forces' magnitudes, bit frame, z = 0; the
/// rock pushes the bit in the opposite direction. 0: balanced; length 1: a single cutter that
/// pushes sideways.
Vec3 imbalance_vector(const std::vector<Cutter>& cutters, const std::vector<double>& areas);

/// The magnitude of imbalance_vector.
double imbalance(const std::vector<Cutter>& cutters, const std::vector<double>& areas);

/// Imbalance of the classical planar model (Warren and Sinor 1986): the force on every cutter is
/// its area against its motion and `normal_ratio` times that along its profile's normal. Returns
/// the lateral resultant of both over the weight; NaN without weight.
double planar_imbalance(const std::vector<Cutter>& cutters, const std::vector<double>& areas,
                        double normal_ratio);

/// The parts of the planar model: lateral forces of the rock on the bit (z = 0), at 1 Pa, m2.
struct PlanarBalance {
  Vec3 normal = Vec3::Zero();  ///< of the forces along the profile's normals
  Vec3 drag = Vec3::Zero();    ///< of the forces against the motion
  double weight = 0.0;         ///< axial resultant, upwards
};

/// The planar model (planar_imbalance) with the lateral resultants of the normal and of the drag
/// forces apart. |normal + drag| / weight is the planar imbalance.
PlanarBalance planar_balance(const std::vector<Cutter>& cutters, const std::vector<double>& areas,
                             double normal_ratio);

/// Mean number of cutters that cut at a radius, weighted by the area of the hole. Measures how well
/// the bit tolerates the loss of a cutter. `cutting`: as in Engagement.
double mean_redundancy(const std::vector<int>& cutting);

}  // namespace tdbd::bit
