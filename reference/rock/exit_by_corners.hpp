#pragma once

#include <optional>
#include <vector>

#include "core/types.hpp"

namespace tdbd::reference {

/// The half-space n . x <= b.
struct HalfSpace {
  Vec3 n;
  double b = 0.0;
};

/// Twin of the search for an exit from a convex solid, rock (3) and (4): the largest t >= 0 for
/// which some tau in [0, 1] puts (1-tau) (q0 + t u0) + tau (q1 + t u1) into all half-spaces.
/// Method: the largest t is at tau = 0, at tau = 1 or where two planes meet on the strip. All of
/// these places are computed; those outside some half-space by more than 1e-12 are dropped; the
/// highest of the others is returned. Returns nothing if none is left. The run time is proportional
/// to the cube of the number of planes.
std::optional<double> exit_by_corners(const std::vector<HalfSpace>& solid_P, const Vec3& q0_P,
                                      const Vec3& q1_P, const Vec3& u0_P, const Vec3& u1_P);

}  // namespace tdbd::reference
