#pragma once

#include "core/types.hpp"

namespace tdbd {

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

}  // namespace tdbd
