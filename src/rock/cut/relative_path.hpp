#pragma once

#include "core/types.hpp"

namespace tdbd::rock {

/// A rock vertex as a moving part sees it during one step, in the part's frame P: at tau in [0, 1]
/// it is at (1-tau) q0 + tau q1, and its update direction is (1-tau) u0 + tau u1 (formulation 2.1:
/// both are straight to second order in the step).
struct RelativePath {
  Vec3 q0_P, q1_P;  ///< m
  Vec3 u0_P, u1_P;  ///< unit at the ends
};

}  // namespace tdbd::rock
