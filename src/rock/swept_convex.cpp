#include "rock/swept_convex.hpp"

#include <algorithm>
#include <limits>

namespace tdbd::rock {
namespace {

/// Follows the surface from x the way t grows, with the planes linearised at x (the product tau t
/// of the turning direction), over as many planes as it takes. Returns where t is largest.
double highest_from(Strip& w, const Exit& x) {
  const auto a = [&](std::size_t i) { return w.along[i] + x.t * w.twist[i]; };
  const auto c = [&](std::size_t i) { return w.up[i] + x.tau * w.twist[i]; };
  const double side = a(x.plane) > 0.0 ? -1.0 : 1.0;
  double tau = x.tau, t = x.t;
  std::size_t on = x.plane;
  for (std::size_t steps = 0; steps <= w.rest.size(); ++steps) {
    if (c(on) <= 0.0 || side * a(on) >= 0.0) break;  // t cannot grow any more
    const double climb = -side * a(on) / c(on);
    double reach = side > 0.0 ? 1.0 - tau : tau;
    on = first_plane_on_way(w, {x.tau, x.t, tau, t, side, climb}, on, reach);
    tau += reach * side;
    t += reach * climb;
    if (on == w.rest.size()) break;
  }
  return std::clamp(tau, 0.0, 1.0);
}

}  // namespace

double depth_inside(const mesh::ConvexSolid& s, const Vec3& x_P) {
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < s.b.size(); ++i)
    depth = std::min(depth, s.b[i] - (s.nx[i] * x_P.x() + s.ny[i] * x_P.y() + s.nz[i] * x_P.z()));
  return depth;
}

bool is_swept(const mesh::ConvexSolid& solid, const RelativePath& path, double depth) {
  const Interval tau = when_inside(solid, path, depth);
  return tau.lo < tau.hi;
}

std::optional<double> exit_distance(const mesh::ConvexSolid& solid, const RelativePath& path,
                                    double depth, Strip& strip) {
  const Interval inside = when_inside(solid, path, depth);
  if (inside.lo >= inside.hi) return std::nullopt;
  put_on_strip(solid, path, strip);
  Exit best = leave_at(strip, 0.5 * (inside.lo + inside.hi));
  constexpr int linearisations = 8;  // quadratic convergence: the turn of u in a step is small
  for (int k = 0; k < linearisations; ++k) {
    const Exit next = leave_at(strip, highest_from(strip, best));
    if (next.t <= best.t) break;
    best = next;
  }
  return std::max(0.0, best.t);
}

}  // namespace tdbd::rock
