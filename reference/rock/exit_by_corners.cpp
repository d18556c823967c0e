#include "reference/rock/exit_by_corners.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::reference {
namespace {

struct Path {
  Vec3 q0, q1, u0, u1;

  Vec3 q(double tau) const { return (1.0 - tau) * q0 + tau * q1; }
  Vec3 u(double tau) const { return (1.0 - tau) * u0 + tau * u1; }
};

bool is_inside(const std::vector<HalfSpace>& solid, const Vec3& x) {
  constexpr double slack = 1e-12;
  return std::ranges::all_of(solid, [&](const HalfSpace& h) { return h.n.dot(x) <= h.b + slack; });
}

/// The t at which the ray at tau meets the plane.
double meets_plane(const Path& p, const HalfSpace& h, double tau) {
  return (h.b - h.n.dot(p.q(tau))) / h.n.dot(p.u(tau));
}

/// The tau at which both planes are met at the same t: (b - n.q) (m.u) - (c - m.q) (n.u) = 0, a
/// quadratic in tau, given by its values at 0, 1/2 and 1.
std::vector<double> meetings(const Path& p, const HalfSpace& g, const HalfSpace& h) {
  const auto f = [&](double tau) {
    return (g.b - g.n.dot(p.q(tau))) * h.n.dot(p.u(tau)) -
           (h.b - h.n.dot(p.q(tau))) * g.n.dot(p.u(tau));
  };
  const double c = f(0.0), a = 2.0 * (f(0.0) + f(1.0) - 2.0 * f(0.5)), b = f(1.0) - a - c;
  const double inside = b * b - 4.0 * a * c;
  if (inside < 0.0) return {};
  const double s = -0.5 * (b + std::copysign(std::sqrt(inside), b));
  std::vector<double> taus;
  if (s != 0.0) taus.push_back(c / s);
  if (std::abs(a) > 1e-12 * std::abs(b)) taus.push_back(s / a);
  return taus;
}

}  // namespace

std::optional<double> exit_by_corners(const std::vector<HalfSpace>& solid, const Vec3& q0_P,
                                      const Vec3& q1_P, const Vec3& u0_P, const Vec3& u1_P) {
  const Path p{q0_P, q1_P, u0_P, u1_P};
  std::optional<double> highest;
  const auto try_place = [&](const HalfSpace& h, double tau) {
    if (!(tau >= 0.0 && tau <= 1.0)) return;
    const double t = meets_plane(p, h, tau);
    if (!std::isfinite(t) || t < highest.value_or(0.0)) return;
    if (is_inside(solid, p.q(tau) + t * p.u(tau))) highest = t;
  };
  for (std::size_t i = 0; i < solid.size(); ++i) {
    try_place(solid[i], 0.0);
    try_place(solid[i], 1.0);
    for (std::size_t k = 0; k < i; ++k)
      for (const double tau : meetings(p, solid[i], solid[k])) {
        try_place(solid[i], tau);  // both, because the ray may lie in one of the two planes
        try_place(solid[k], tau);
      }
  }
  return highest;
}

}  // namespace tdbd::reference
