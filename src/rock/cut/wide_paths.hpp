#pragma once

#include <array>

#include "core/pose.hpp"
#include "core/wide.hpp"
#include "rock/cut/group_motion.hpp"
#include "rock/cut/relative_path.hpp"

namespace tdbd::rock {

/// Vectors of four vertices, one per lane. For loops that are TDBD_WIDE; all functions are inlined.
struct WideVec3 {
  Wide x, y, z;
};

TDBD_INLINE Vec3 lane_of(const WideVec3& x, std::size_t l) { return {x.x[l], x.y[l], x.z[l]}; }

/// The sums have the order of Eigen's products, so each lane is bitwise equal to `R * x`.
TDBD_INLINE void rotate(const Mat3& R, const WideVec3& x, WideVec3& y) {
  y.x = R(0, 0) * x.x + (R(0, 1) * x.y + R(0, 2) * x.z);
  y.y = R(1, 0) * x.x + (R(1, 1) * x.y + R(1, 2) * x.z);
  y.z = R(2, 0) * x.x + (R(2, 1) * x.y + R(2, 2) * x.z);
}

TDBD_INLINE void transform(const Pose& X, const WideVec3& x, WideVec3& y) {
  rotate(X.R, x, y);
  y.x += X.p.x();
  y.y += X.p.y();
  y.z += X.p.z();
}

/// Transposes a 4 x 4 matrix: a becomes the first element of each of the four, b the second, and so
/// on.
TDBD_INLINE void transpose(Wide& a, Wide& b, Wide& c, Wide& d) {
  const Wide ab0 = __builtin_shufflevector(a, b, 0, 4, 2, 6),
             ab1 = __builtin_shufflevector(a, b, 1, 5, 3, 7),
             cd0 = __builtin_shufflevector(c, d, 0, 4, 2, 6),
             cd1 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab0, cd0, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab1, cd1, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab0, cd0, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab1, cd1, 2, 3, 6, 7);
}

/// The square root of each lane, correctly rounded.
TDBD_INLINE void square_root(const Wide& x, Wide& root) {
  root =
      Wide{__builtin_sqrt(x[0]), __builtin_sqrt(x[1]), __builtin_sqrt(x[2]), __builtin_sqrt(x[3])};
}

/// Paths of four vertices relative to a group (RelativePath), and their update directions.
struct WidePaths {
  WideVec3 q0, q1;  ///< m, in P
  WideVec3 u0, u1;  ///< in P
  WideVec3 u_W;
};

/// mapped_direction_W and relative_path for four vertices at these places (m), bitwise the same.
/// Only for groups without a core.
void find_paths(const CuttingGroup& g, const GroupMotion& m,
                const std::array<const Vec3*, lanes>& x_W, WidePaths& paths);

inline RelativePath path_of(const WidePaths& p, std::size_t l) {
  return {lane_of(p.q0, l), lane_of(p.q1, l), lane_of(p.u0, l), lane_of(p.u1, l)};
}

}  // namespace tdbd::rock
