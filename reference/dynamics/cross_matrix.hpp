#pragma once

#include "core/types.hpp"

namespace tdbd::reference {

/// cross_matrix(a) b = a x b.
inline Mat3 cross_matrix(const Vec3& a) {
  Mat3 A;
  A << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return A;
}

}  // namespace tdbd::reference
