#pragma once

#include "core/pose.hpp"

namespace tdbd::rock {

/// The path of a rock vertex relative to a moving part during one step, in the part's frame P, rock
/// (1). At tau in [0, 1] the vertex is at (1-tau) q0 + tau q1, and its update direction is (1-tau)
/// u0 + tau u1. Both are linear to second order in the step.
struct RelativePath {
  Vec3 q0_P, q1_P;  ///< m
  Vec3 u0_P, u1_P;  ///< unit vectors
};

/// The path of a vertex at x_W with update direction u_W relative to a part with these poses.
inline RelativePath relative_path(const Pose& X_PW0, const Pose& X_PW1, const Vec3& x_W,
                                  const Vec3& u_W) {
  return {X_PW0 * x_W, X_PW1 * x_W, X_PW0.R * u_W, X_PW1.R * u_W};
}

}  // namespace tdbd::rock
