#pragma once

#include <Eigen/Geometry>

#include "rotation/stumpff.hpp"

namespace tdbd::rotation {

/// @file
/// Unit quaternions as attitudes. S is double or a scalar type with derivatives.

/// Rotation by |v| (rad) about v; rotation (1).
template <class S>
Eigen::Quaternion<S> quaternion_exp(const Eigen::Matrix<S, 3, 1>& v) {
  const CosSinc<S> half = cos_sinc<S>(0.25 * v.squaredNorm());
  const S f = 0.5 * half.sinc;
  return {half.cos, f * v[0], f * v[1], f * v[2]};
}

/// One Newton step towards unit length: a squared length of 1 + d gives a length of 1 - 3 d^2 / 8.
template <class S>
void renormalise(Eigen::Quaternion<S>& q) {
  q.coeffs() *= 1.5 - 0.5 * q.squaredNorm();
}

}  // namespace tdbd::rotation
