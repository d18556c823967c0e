#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/cone/cone_parts.hpp"

namespace tdbd::bit {

/// The smallest gap between two solids of revolution, and its place on the first.
struct Gap {
  double distance = 0.0;  ///< m, signed; negative: depth of the first in the second
  ShellPoint point_a;     ///< on the first one's meridian
  double angle_a = 0.0;   ///< rad about the first one's axis
  bool is_exact = true;   ///< to the tolerance; false if the search stopped at most_patches
};

/// Largest number of patches that a search examines. Cones that turn clear of each other take some
/// hundred. Where two solids nearly coincide, all patches are equally near.
inline constexpr long most_patches = 200'000;

/// Returns the gap between the surface of solid A (frame X_BA) and solid B (frame X_BB), the global
/// minimum to `tolerance` (m). Branch and bound over A's meridian and angle: the signed distance
/// changes by no more than the point moves. Stops early if no gap is below `enough` (m), and then
/// returns one at least that large, or after most_patches. A solid B completely inside A is not
/// detected.
Gap smallest_gap(const Meridian& a, const Pose& X_BA, const Meridian& b, const Pose& X_BB,
                 double tolerance, double enough);

/// The smallest distance of two parts of neighbouring cones in full turns of both, and its place.
struct Clearance {
  std::string part_a, part_b;  ///< "cone-1/row-2/tooth-1", "cone-2/body"
  double distance = 0.0;       ///< m; negative: depth of an overlap
  double angle_a = 0.0;        ///< rad, of cone a when its part is at that place
  double angle_b = 0.0;        ///< rad, of cone b
  Vec3 place_B = Vec3::Zero();
  bool is_exact = true;  ///< false: the search stopped early (most_patches)
};

/// Formats a clearance: "an overlap of 1.203 mm of cone-1/row-2/tooth-1 (at 34.2 deg) and
/// cone-2/body (at 120.0 deg) at (1.0, 2.0, 3.0) mm", or "a gap of ...", or that it could not be
/// determined. Angles are those of the cones; the place is in the bit's frame.
std::string clearance_text(const Clearance& c);

/// Accuracy (m) of the clearances.
inline constexpr double clearance_tolerance = 1e-5;

/// Whether parts overlap, or may overlap because the search did not finish.
inline bool is_clash(const Clearance& c) { return c.distance < 0.0 || !c.is_exact; }

/// What turns with a cone: its shell, or a row, represented by its first tooth.
struct Turning {
  std::string part;    ///< "cone-1/body", "cone-1/row-2/tooth-1"
  double first_angle;  ///< rad, of that tooth
  Meridian meridian;   ///< of the volume that it sweeps (row_meridian)
};

/// The shell and the rows of a cone, from the nose to the base.
std::vector<Turning> turning_parts(const Cone& cone);

/// For every two cones of a bit, returns every clash between a shell or row of teeth of one cone
/// and those of the other, or, if there is none, the smallest gap between the two. Cones turn
/// independently, so every tooth is at every angle at some time. Therefore the volumes swept by
/// shells and rows are compared (swept_meridian), and any tooth represents its row. Conservative by
/// the slack of swept_meridian. Cones without a shell, whose solids were read from a file, are
/// skipped. Sorted by distance.
std::vector<Clearance> cone_clearances(const std::vector<Cone>& cones);

/// The smallest distance of a leg and a part of a cone in a full turn of the cone, and its place.
struct LegClearance {
  std::string leg;        ///< "leg-1"
  std::string part;       ///< "cone-1/body", "cone-2/row-4/tooth-1"
  double distance = 0.0;  ///< m; negative: depth of the leg in the volume that the part sweeps
  double angle = 0.0;     ///< rad, of the cone when its part is at that place
  Vec3 place_B = Vec3::Zero();
};

/// Formats a clearance: "an overlap of 1.203 mm of leg-1 and cone-2/row-4/tooth-1 (at 34.2 deg) at
/// (1.0, 2.0, 3.0) mm", or "a gap of ...". The angle is that of the cone; the place is in the bit's
/// frame.
std::string clearance_text(const LegClearance& c);

/// For every leg and every cone of a bit, returns every overlap of the leg with the volume swept by
/// the cone's shell or a row of its teeth, or, if there is none, the smallest gap between the two,
/// to clearance_tolerance. Branch and bound over the leg's triangles: the signed distance from a
/// solid of revolution changes by no more than the point moves. Conservative by the slack of
/// swept_meridian; a lower bound if most_patches is reached. A cone completely inside a leg is not
/// detected. Cones without a shell are skipped. Sorted by distance.
std::vector<LegClearance> leg_clearances(const Bit& bit);

}  // namespace tdbd::bit
