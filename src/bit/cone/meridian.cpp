#include "bit/cone/meridian.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace tdbd::bit {
namespace {

double cross(const ShellPoint& o, const ShellPoint& a, const ShellPoint& b) {
  return (a.s - o.s) * (b.r - o.r) - (a.r - o.r) * (b.s - o.s);
}

double squared_distance(const ShellPoint& a, const ShellPoint& b, const ShellPoint& p) {
  const double ds = b.s - a.s, dr = b.r - a.r, length2 = ds * ds + dr * dr;
  const double along = length2 > 0.0 ? ((p.s - a.s) * ds + (p.r - a.r) * dr) / length2 : 0.0;
  const double t = std::clamp(along, 0.0, 1.0);
  return std::pow(p.s - a.s - t * ds, 2) + std::pow(p.r - a.r - t * dr, 2);
}

/// Whether a ray from p towards +r crosses the side.
bool crosses(const ShellPoint& a, const ShellPoint& b, const ShellPoint& p) {
  if ((a.s > p.s) == (b.s > p.s)) return false;
  return a.r + (p.s - a.s) * (b.r - a.r) / (b.s - a.s) > p.r;
}

/// The convex hull, by Andrew's monotone chains.
Meridian hull(Meridian points) {
  std::ranges::sort(points, {}, [](const ShellPoint& p) { return std::tuple(p.s, p.r); });
  Meridian chain;
  const auto add = [&](const ShellPoint& p, std::size_t keep) {
    while (chain.size() > keep && cross(chain[chain.size() - 2], chain.back(), p) <= 0.0)
      chain.pop_back();
    chain.push_back(p);
  };
  for (const ShellPoint& p : points) add(p, 1);
  const std::size_t lower = chain.size();
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) add(*p, lower);
  chain.pop_back();
  return chain;
}

}  // namespace

double signed_distance(const Meridian& solid, const ShellPoint& p) {
  double nearest = std::numeric_limits<double>::infinity();
  bool is_inside = false;
  for (std::size_t i = 0; i < solid.size(); ++i) {
    const ShellPoint &a = solid[i], &b = solid[(i + 1) % solid.size()];
    if (a.r != 0.0 || b.r != 0.0) nearest = std::min(nearest, squared_distance(a, b, p));
    is_inside = is_inside != crosses(a, b, p);
  }
  return is_inside ? -std::sqrt(nearest) : std::sqrt(nearest);
}

Meridian shell_meridian(const std::vector<ShellPoint>& shell) {
  Meridian m;
  if (shell.front().r > 0.0) m.push_back({shell.front().s, 0.0});
  m.insert(m.end(), shell.begin(), shell.end());
  if (shell.back().r > 0.0) m.push_back({shell.back().s, 0.0});
  return m;
}

Meridian swept_meridian(const mesh::TriangleMesh& convex_P, const Pose& X_KP) {
  Meridian points;
  for (const Vec3& x_P : convex_P.positions) {
    const Vec3 x_K = X_KP * x_P;
    const double angle = std::atan2(X_KP.p.y(), X_KP.p.x());
    const double inward = std::cos(angle) * x_K.x() + std::sin(angle) * x_K.y();
    points.push_back({-x_K.z(), std::hypot(x_K.x(), x_K.y())});
    points.push_back({-x_K.z(), std::max(0.0, inward)});
  }
  return hull(points);
}

}  // namespace tdbd::bit
