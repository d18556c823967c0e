#include "rock/twist.hpp"

#include <cmath>

namespace tdbd::rock {

Pose carried(const Twist& twist, double s) {
  const Vec3 turn = s * twist.angular_B;
  const double x = turn.squaredNorm(), angle = std::sqrt(x), half = 0.5 * angle;
  double c1 = 1.0 - x / 6.0, c2 = 0.5 - x / 24.0, c3 = 1.0 / 6.0 - x / 120.0;
  constexpr double series_end = 1e-7;  // next terms: x^2 / 120, / 720, / 5040, below rounding
  if (x > series_end) {
    c1 = std::sin(angle) / angle;
    c2 = 2.0 * std::sin(half) * std::sin(half) / x;
    c3 = (1.0 - c1) / x;
  }
  Mat3 S;
  S << 0.0, -turn.z(), turn.y(), turn.z(), 0.0, -turn.x(), -turn.y(), turn.x(), 0.0;
  const Mat3 S2 = S * S;
  return {Mat3::Identity() + c1 * S + c2 * S2,
          s * (twist.linear_B + c2 * (S * twist.linear_B) + c3 * (S2 * twist.linear_B))};
}

}  // namespace tdbd::rock
