#pragma once

#include "bit/cone/meridian.hpp"

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

}  // namespace tdbd::bit
