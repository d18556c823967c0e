#pragma once

#include <Eigen/Dense>
#include <cstddef>

namespace tdbd {

/// Vectors carry their frame in their names: p_WB is the position from W to B, expressed in W;
/// n_C is a direction expressed in C. W: space (z down, the drilling direction), B: bit,
/// P: a part, C: a cutter. Lengths in m, angles in rad, SI throughout.
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Converts an index (int: of positions, triangles, parts) to what the standard containers take. It must not be
/// negative.
constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace tdbd
