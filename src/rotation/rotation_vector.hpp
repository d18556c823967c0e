#pragma once

#include "core/types.hpp"

namespace tdbd::rotation {

/// The skew-symmetric matrix of a: skew(a) b = a x b.
Mat3 skew(const Vec3& a);

/// Rotation by |v| (rad) about v (Rodrigues formula; series near zero). rotation (1); thesis: 5.1.
Mat3 exp(const Vec3& v);

/// Rotation vector of R with an angle in [0, pi], rad: rotation (2), computed by quaternion,
/// accurate near 0 and pi.
Vec3 log(const Mat3& R);

}  // namespace tdbd::rotation
