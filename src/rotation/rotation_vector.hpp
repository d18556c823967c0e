#pragma once

#include "core/types.hpp"

namespace tdbd::rotation {

/// skew(a) b = a x b.
Mat3 skew(const Vec3& a);

/// Rotation by |v| about v (Rodrigues; series near zero). Thesis: 5.1, formulation 5.
Mat3 exp(const Vec3& v);

/// Rotation vector of R with angle in [0, pi] (by quaternion, accurate near 0 and pi).
Vec3 log(const Mat3& R);

}  // namespace tdbd::rotation
