#pragma once

#include <array>

#include "rock/cut/group_motion.hpp"
#include "rock/cut/relative_path.hpp"
#include "rock/cut/wide_vectors.hpp"

namespace tdbd::rock {

/// Paths of four vertices past a group, as RelativePath has them, and their update directions.
struct WidePaths {
  WideVec3 q0, q1;  ///< m, in P
  WideVec3 u0, u1;  ///< in P
  WideVec3 u_W;
};

/// mapped_direction_W and relative_path for four vertices at these places (m), bitwise the same. For
/// groups without a core.
void find_paths(const CuttingGroup& g, const GroupMotion& m,
                const std::array<const Vec3*, lanes>& x_W, WidePaths& paths);

inline RelativePath path_of(const WidePaths& p, std::size_t l) {
  return {lane_of(p.q0, l), lane_of(p.q1, l), lane_of(p.u0, l), lane_of(p.u1, l)};
}

}  // namespace tdbd::rock
