#pragma once

#include <limits>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Axial depth of the land inside the chamfer, m: width along the face / tan(angle from the axis).
double land_depth(const Cutter& c);

/// Axial depth of the whole chamfer, m: the depths of the land and of the chamfer at the rim.
double chamfer_depth(const Cutter& c);

/// The tip in the cutter frame, m: (-chamfer_depth, 0, -D/2), on the outer rim of the chamfer, or
/// on the rim of the face if the edge is sharp.
Vec3 tip_C(const Cutter& c);

/// The tip in the bit frame, m: (r cos phi, r sin phi, -h).
Vec3 tip_B(const Cutter& c);

/// Unit direction in which the tip moves as the bit rotates, in the bit frame.
Vec3 direction_of_motion_B(const Cutter& c);

/// Unit normal of the bit's profile into the rock at the cutter, in the bit frame: n = sin(theta)
/// e_r + cos(theta) e_z, with e_r radial at the cutter's azimuth and e_z down.
Vec3 profile_normal_B(const Cutter& c);

/// Computes the pose of a cutter in the bit frame, bit (1). Origin: centre of the face. X is the
/// face's outward normal; -Z lies in the face and points from the bit to the rock. The face leans
/// over the rock ahead of it, so the body clears the rock behind the edge. The tip is exactly at
/// its place in the table. With side rake s, the point of the rim farthest along the profile's
/// normal is not quite the tip: it reaches (D/2) (sqrt(cos^2 b + sin^2 s sin^2 b) - cos b) farther,
/// 3 micrometres on a usual bit, with b the back rake and D the diameter. Reads every field except
/// X_BC. Thesis: 3.2.2 (origin) and 4.1.2.1 (the negative of Z is projected). X and Y are
/// reconstructed because page 23 is missing.
Pose cutter_pose(const Cutter& c);

/// Number of points of a turned outline where its accuracy matters.
inline constexpr int rim_points = 1440;

/// The rim of a cutter rotated into one half-plane about the bit's axis, m: x is the radius, y the
/// azimuth (rad, within half a turn of the cutter's), z the bit's z. Has `points` points, starting
/// at the tip. Where the cutter is worn, the rim is moved back along the profile's normal to its
/// flat.
std::vector<Vec3> turned_outline(const Cutter& c, int points);

/// The deepest point of a cutter's rim at one radius.
struct RimReach {
  double z = -std::numeric_limits<double>::infinity();  ///< m, bit frame
  double azimuth = 0.0;                                 ///< rad

  /// Whether the rim extends over this radius.
  bool reached() const { return z != -std::numeric_limits<double>::infinity(); }
};

/// The reach of every cutter, at the centres of equal columns of radius from the axis to the widest
/// rim.
struct RimReaches {
  std::vector<std::vector<RimReach>> of_cutter;  ///< [cutter][column]
  double width = 0.0;                            ///< m; column k is centred at (k + 1/2) width
};

/// Computes the reaches in columns of at most `column_width` (m). Chamfers lie inside the rim.
RimReaches rim_reaches(const std::vector<Cutter>& cutters, double column_width);

/// `graded`: fine at the rim, coarse at the centre (fig. 3.9). `uniform`: about equal edges
/// everywhere, the mesh that the dissertation names as a cause of noise (ch. 6); kept for
/// comparison.
enum class Grading { graded, uniform };

/// Meshing of a cutter's parts.
struct CutterMeshing {
  Grading grading = Grading::graded;
  int rim_segments = 64;       ///< graded only
  double uniform_edge = 2e-3;  ///< m, uniform only
};

/// Density of the polycrystalline diamond table and of the tungsten carbide body, kg/m3.
inline constexpr double table_density = 3500.0;
inline constexpr double carbide_density = 14500.0;

/// Makes the parts of a cutter, in this order, all in its frame and at its pose. They are closed,
/// convex, inscribed meshes with rim points at the same angles, one of them the tip:
///   cutter-N/face     cylinder, x in [-f, 0], radius D/2 - land - chamfer
///   cutter-N/land     frustum from there to radius D/2 - chamfer; absent without a land
///   cutter-N/chamfer  frustum from there to radius D/2 at x = -f; absent if the edge is sharp
///   cutter-N/body     cylinder, x in [-length, -f], radius D/2
/// f is the axial depth of the chamfers, or the thickness of the table if the edge is sharp. The
/// frustums enclose the face, whose density is then 0. The parts of a worn cutter end in the plane
/// normal to the profile's normal that is below the tip by the cutter's wear. A part that this
/// plane removes entirely is absent. The caller sets `group` and `cutter`. Thesis: 3.2.2, 3.3,
/// figs. 3.8 and 3.9.
std::vector<Part> cutter_parts(const Cutter& c, const CutterMeshing& meshing);

/// Whether the gap between the solids of two cutters is less than `clearance` (m, > 0). A solid is
/// the cylinder of the cutter's diameter and length behind its face. The method projects
/// alternately onto one and the other. The distance of the projections never increases, and the
/// planes normal to it that touch both solids bound the gap from below. Cutters that are still
/// undecided after many iterations count as closer; this occurs only if the gap is within a
/// micrometre of the clearance. Reads sizes and poses.
bool closer_than(const Cutter& a, const Cutter& b, double clearance);

/// Two cutters whose solids share volume, which counts twice in the mass.
struct CutterOverlap {
  int a = 0, b = 0;     ///< indices into Bit::cutters, a < b
  double volume = 0.0;  ///< m3
};

/// Returns every pair of cutters that overlap, sorted by index. A cutter's solid is the union of
/// its parts that have a density, which are convex and disjoint. So the volume is a sum over pairs
/// of parts, each part clipped by the planes of the other (mesh/shape/clip_convex.hpp). Exact for
/// the meshes, which are inscribed. Solids that only touch do not overlap.
std::vector<CutterOverlap> cutter_overlaps(const Bit& bit);

}  // namespace tdbd::bit
