#pragma once

#include "bit/cone/meridian.hpp"

namespace tdbd::bit {

/// The smallest gap between two solids of revolution, and where on the first it is.
struct Gap {
  double distance = 0.0;  ///< m, signed: negative is the depth to which the first enters the second
  ShellPoint point_a;     ///< on the first one's meridian
  double angle_a = 0.0;   ///< rad about the first one's axis
  bool is_exact = true;   ///< to the tolerance; false: most_patches did not suffice
};

/// Patches that a search looks at before it gives up. Cones that turn clear of each other take some hundred; where two
/// solids nearly coincide, every patch is as near as the others.
inline constexpr long most_patches = 200'000;

/// The gap between the surface of solid A (frame X_BA) and solid B (frame X_BB), the smallest of
/// all to `tolerance` (m). Branch and bound over A's meridian and angle: the signed distance
/// changes by no more than the point moves. Stops early when no gap below `enough` (m) exists, and
/// then returns one at least that large, and after most_patches. A solid that lies wholly inside A is not detected.
Gap smallest_gap(const Meridian& a, const Pose& X_BA, const Meridian& b, const Pose& X_BB,
                 double tolerance, double enough);

}  // namespace tdbd::bit
