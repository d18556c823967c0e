#include "bit/cutter/cutter_gap.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::bit {
namespace {

constexpr int most_turns = 1000;

Vec3 centre_B(const Cutter& c) { return c.X_BC * Vec3(-0.5 * c.length, 0.0, 0.0); }

double bounding_radius(const Cutter& c) { return 0.5 * std::hypot(c.length, c.diameter); }

/// The point of the cutter's cylinder that is nearest to x_B.
Vec3 nearest_B(const Cutter& c, const Vec3& x_B) {
  Vec3 x_C = c.X_BC.R.transpose() * (x_B - c.X_BC.p);
  x_C.x() = std::clamp(x_C.x(), -c.length, 0.0);
  const double radius = std::hypot(x_C.y(), x_C.z());
  if (radius > 0.5 * c.diameter) x_C.tail<2>() *= 0.5 * c.diameter / radius;
  return c.X_BC * x_C;
}

/// How far the cylinder extends along the unit vector d_B.
double reach_along(const Cutter& c, const Vec3& d_B) {
  const double along = c.X_BC.R.col(0).dot(d_B);
  const double across = std::sqrt(std::max(0.0, 1.0 - along * along));
  return d_B.dot(centre_B(c)) + 0.5 * c.length * std::abs(along) + 0.5 * c.diameter * across;
}

}  // namespace

bool closer_than(const Cutter& a, const Cutter& b, double clearance) {
  const double centres = (centre_B(a) - centre_B(b)).norm();
  if (centres >= bounding_radius(a) + bounding_radius(b) + clearance) return false;
  Vec3 in_a = centre_B(a);
  for (int turn = 0; turn < most_turns; ++turn) {
    const Vec3 in_b = nearest_B(b, in_a);
    in_a = nearest_B(a, in_b);
    const double distance = (in_a - in_b).norm();
    if (distance < clearance) return true;
    const Vec3 d = (in_b - in_a) / distance;
    if (-reach_along(b, -d) - reach_along(a, d) >= clearance) return false;
  }
  return true;
}

}  // namespace tdbd::bit
