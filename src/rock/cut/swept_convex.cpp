#include "rock/cut/swept_convex.hpp"

#include <algorithm>
#include <limits>

namespace tdbd::rock {
namespace {

/// A better estimate than `tau` of where planes k and l meet on the strip, with the same t: one
/// step of Newton's method on a quadratic.
double towards_meeting(const PlaneStrip& w, std::size_t k, std::size_t l, double tau) {
  const double room_k = w.rest[k] - w.along[k] * tau, c_k = w.up[k] + w.twist[k] * tau;
  const double room_l = w.rest[l] - w.along[l] * tau, c_l = w.up[l] + w.twist[l] * tau;
  const double slope =
      w.along[l] * c_k - w.along[k] * c_l + room_k * w.twist[l] - room_l * w.twist[k];
  return slope == 0.0 ? tau : tau - (room_k * c_l - room_l * c_k) / slope;
}

/// Climbs along the solid's surface from x, with the planes linearised at x (the product tau t of
/// the turning direction), over as many planes as it takes. Returns the tau of the largest t: where
/// the last two planes meet, not linearised.
double highest_from(const PlaneStrip& w, const Exit& x) {
  const auto a = [&](std::size_t i) { return w.along[i] + x.t * w.twist[i]; };
  const auto c = [&](std::size_t i) { return w.up[i] + x.tau * w.twist[i]; };
  const double side = a(x.plane) > 0.0 ? -1.0 : 1.0;
  double tau = x.tau, t = x.t;
  std::size_t on = x.plane, before = x.plane;
  for (std::size_t steps = 0; steps <= w.rest.size(); ++steps) {
    if (c(on) <= 0.0 || side * a(on) >= 0.0) {  // t cannot grow any more
      for (int k = 0; k < 2 && before != on; ++k) tau = towards_meeting(w, before, on, tau);
      break;
    }
    const double climb = -side * a(on) / c(on);
    double reach = side > 0.0 ? 1.0 - tau : tau;
    before = on;
    on = first_plane_on_way(w, {x.tau, x.t, tau, t, side, climb}, on, reach);
    tau += reach * side;
    t += reach * climb;
    if (on == w.rest.size()) break;
  }
  return std::clamp(tau, 0.0, 1.0);
}

bool meets_solid(const Exit& x) {
  constexpr double touching = 1e-12;  // m
  return x.entry <= x.t + touching;
}

/// The exit at tau. Where the ray at tau misses the solid, because the linearised way overshoots
/// the solid's end: the exit at that end, where the plane that the ray leaves too soon meets the
/// one it enters too late.
Exit leave_towards(const PlaneStrip& w, const Exit& in, double tau) {
  Exit x = leave_at(w, tau);
  constexpr int newton_steps = 8;
  for (int k = 0; k < newton_steps && !meets_solid(x); ++k) {
    tau = towards_meeting(w, x.plane, last_entered(w, tau), tau);
    tau = std::clamp(tau, std::min(in.tau, x.tau), std::max(in.tau, x.tau));
    x = leave_at(w, tau);
  }
  return meets_solid(x) ? x : in;
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
                                    double depth, PlaneStrip& strip) {
  const Interval inside = when_inside(solid, path, depth);
  if (inside.lo >= inside.hi) return std::nullopt;
  put_on_strip(solid, path, strip);
  Exit best = leave_at(strip, 0.5 * (inside.lo + inside.hi));
  if (best.t == std::numeric_limits<double>::infinity()) return best.t;  // open that way
  constexpr int linearisations = 8;  // quadratic convergence: the turn of u in a step is small
  for (int k = 0; k < linearisations; ++k) {
    const Exit next = leave_towards(strip, best, highest_from(strip, best));
    if (next.t <= best.t) break;
    best = next;
  }
  return std::max(0.0, best.t);
}

}  // namespace tdbd::rock
