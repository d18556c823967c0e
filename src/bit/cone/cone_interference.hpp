#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// How near two parts of neighbouring cones come in full turns of both, and where.
struct Clearance {
  std::string part_a, part_b;  ///< "cone-1/row-2/tooth-1", "cone-2/body"
  double distance = 0.0;       ///< m; negative: they overlap, to this depth
  double angle_a = 0.0;        ///< rad, of cone a when its part is at the place
  double angle_b = 0.0;        ///< rad, of cone b
  Vec3 place_B = Vec3::Zero();
};

/// "an overlap of 1.203 mm of cone-1/row-2/tooth-1 (at 34.2 deg) and cone-2/body (at 120.0 deg) at
/// (1.0, 2.0, 3.0) mm", or "a gap of ..."; angles of the cones, place in the bit's frame.
std::string clearance_text(const Clearance& c);

/// The gaps that are smaller than this are known to this, m.
inline constexpr double clearance_tolerance = 1e-5;

/// For every two cones of a bit: every overlap of a shell or a row of teeth of one with those of
/// the other; and, where there is none, the smallest gap between the two. Cones turn independently,
/// so a tooth stands at every angle of its turn in time: what counts is what shells and rows sweep
/// (swept_meridian), and any tooth of a row stands for it. Conservative by swept_meridian's slack.
/// Cones without a shell, whose solids were drawn, are passed over. Sorted by distance.
std::vector<Clearance> cone_clearances(const std::vector<Cone>& cones);

}  // namespace tdbd::bit
