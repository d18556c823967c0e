#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/cone/meridian.hpp"

namespace tdbd::bit {

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

}  // namespace tdbd::bit
