#include "reference/literature/drag/planes/bit_path.hpp"

#include <cmath>
#include <numbers>

namespace tdbd::reference {
namespace {

double depth_after(double angle, double advance) {
  return advance * angle / (2 * std::numbers::pi);
}

}  // namespace

Vec3 turned(const BitPlace& place, const Vec3& v_B) {
  const double c = std::cos(place.angle), s = std::sin(place.angle);
  return {c * v_B.x() - s * v_B.y(), s * v_B.x() + c * v_B.y(), v_B.z()};
}

BitPlace between(const BitPlace& from, const BitPlace& to, double share) {
  return {from.p_WB + share * (to.p_WB - from.p_WB), std::lerp(from.angle, to.angle, share)};
}

BitPath steady_path(double rotary_speed, double advance) {
  return [=](double t) {
    const double angle = rotary_speed * t;
    return BitPlace{Vec3(0.0, 0.0, depth_after(angle, advance)), angle};
  };
}

BitPath whirl_path(const RollingWhirl& whirl, double advance) {
  return [=](double t) {
    const double angle = whirl.rotary_speed * t, around = whirl.whirl_speed() * t;
    return BitPlace{Vec3(whirl.radius * std::cos(around), whirl.radius * std::sin(around),
                         depth_after(angle, advance)),
                    angle};
  };
}

double forward_speed(const RollingWhirl& whirl, double r, double delta) {
  return whirl.rotary_speed * (r - whirl.bit_radius * std::cos(delta));
}

double speed(const RollingWhirl& whirl, double r, double delta) {
  const double R = whirl.bit_radius;
  const double square = r * r + R * R - 2 * r * R * std::cos(delta);
  return whirl.rotary_speed * std::sqrt(std::max(0.0, square));
}

double backward_share(const RollingWhirl& whirl, double r) {
  return std::acos(r / whirl.bit_radius) / std::numbers::pi;
}

double mean_speed(const RollingWhirl& whirl, double r) {
  constexpr int points = 20000;  // midpoint rule for a periodic function
  double sum = 0.0;
  for (int k = 0; k < points; ++k)
    sum += speed(whirl, r, 2 * std::numbers::pi * (k + 0.5) / points);
  return sum / points;
}

}  // namespace tdbd::reference
