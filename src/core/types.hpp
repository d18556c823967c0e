#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <numbers>

namespace tdbd {

/// Names of vectors contain their frame: p_WB is the position from W to B, expressed in W; n_C is a
/// direction expressed in C. W: space (z down, the drilling direction), B: bit, P: a part, C: a
/// cutter. Lengths in m, angles in rad, SI units throughout.
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Converts an index (int) to the index type of the standard containers. It must not be negative.
constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Pose of a frame B in a frame A: x_A = R * x_B + p. Named X_AB, so that X_AC = X_AB * X_BC.
/// Thesis: 3.2 (coordinate systems).
struct Pose {
  Mat3 R = Mat3::Identity();  ///< rotation, B to A
  Vec3 p = Vec3::Zero();      ///< origin of B in A, m

  Vec3 operator*(const Vec3& x_B) const { return R * x_B + p; }
  Pose operator*(const Pose& X_BC) const { return {R * X_BC.R, R * X_BC.p + p}; }
  Vec3 rotate(const Vec3& v_B) const { return R * v_B; }

  template <class Archive>
  void serialize(Archive& a) {
    a(R, p);
  }
};

inline Pose inverse(const Pose& X_AB) {
  return {X_AB.R.transpose(), -(X_AB.R.transpose() * X_AB.p)};
}

/// Angles in rad.
inline constexpr double pi = std::numbers::pi;
inline constexpr double full_turn = 2.0 * std::numbers::pi;
inline constexpr double right_angle = 0.5 * std::numbers::pi;
inline constexpr double degree = std::numbers::pi / 180.0;

}  // namespace tdbd
