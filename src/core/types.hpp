#pragma once

#include <Eigen/Dense>
#include <cstddef>

namespace tdbd {

/// Names of vectors contain their frame: p_WB is the position from W to B, expressed in W; n_C is a
/// direction expressed in C. W: space (z down, the drilling direction), B: bit, P: a part, C: a
/// cutter. Lengths in m, angles in rad, SI units throughout.
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Converts an index (int) to the index type of the standard containers. It must not be negative.
constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace tdbd
