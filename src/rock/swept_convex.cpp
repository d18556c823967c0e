#include "rock/swept_convex.hpp"

#include <algorithm>
#include <limits>

namespace tdbd::rock {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Interval {
  double lo, hi;
};

/// For plane i: rest[i] = b - n.q0, along[i] = n.(q1-q0): inside while along tau < rest.
Interval prepare(const mesh::ConvexSolid& s, const RelativePath& p, double depth,
                 ConvexScratch& w) {
  const Vec3 d = p.q1_P - p.q0_P;
  const auto n = static_cast<std::size_t>(s.planes());
  w.rest.resize(n);
  w.along.resize(n);
  Interval tau{0.0, 1.0};
  for (std::size_t i = 0; i < n; ++i) {
    w.rest[i] = s.b[i] - (s.nx[i] * p.q0_P.x() + s.ny[i] * p.q0_P.y() + s.nz[i] * p.q0_P.z());
    w.along[i] = s.nx[i] * d.x() + s.ny[i] * d.y() + s.nz[i] * d.z();
    const double room = w.rest[i] - depth;
    if (w.along[i] > 0.0)
      tau.hi = std::min(tau.hi, room / w.along[i]);
    else if (w.along[i] < 0.0)
      tau.lo = std::max(tau.lo, room / w.along[i]);
    else if (room <= 0.0)
      tau.hi = -infinity;
    if (tau.lo >= tau.hi) return tau;
  }
  return tau;
}

void prepare_directions(const mesh::ConvexSolid& s, const RelativePath& p, ConvexScratch& w) {
  const Vec3 du = p.u1_P - p.u0_P;
  const auto n = static_cast<std::size_t>(s.planes());
  w.up.resize(n);
  w.twist.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    w.up[i] = s.nx[i] * p.u0_P.x() + s.ny[i] * p.u0_P.y() + s.nz[i] * p.u0_P.z();
    w.twist[i] = s.nx[i] * du.x() + s.ny[i] * du.y() + s.nz[i] * du.z();
  }
}

struct Point {
  double tau, t;
};

/// Largest t with (along + t0 twist) tau + (up + tau0 twist) t <= rest + tau0 t0 twist: the planes
/// linearised at (tau0, t0). Climbs straight up from (start, 0), then from plane to plane.
Point climb(const ConvexScratch& w, double start, Point at) {
  const std::size_t n = w.rest.size();
  Point x{start, 0.0};
  Point go{0.0, 1.0};
  for (std::size_t steps = 0; steps <= 2 * n; ++steps) {
    double reach = go.tau > 0.0   ? (1.0 - x.tau) / go.tau
                   : go.tau < 0.0 ? -x.tau / go.tau
                                  : infinity;
    std::size_t blocking = n;
    for (std::size_t i = 0; i < n; ++i) {
      const double a = w.along[i] + at.t * w.twist[i], c = w.up[i] + at.tau * w.twist[i];
      const double speed = a * go.tau + c * go.t;
      if (speed <= 1e-14) continue;
      const double room = w.rest[i] + at.tau * at.t * w.twist[i] - a * x.tau - c * x.t;
      if (room < reach * speed) {
        reach = std::max(0.0, room / speed);
        blocking = i;
      }
    }
    x.tau += reach * go.tau;
    x.t += reach * go.t;
    if (blocking == n) return x;
    const double a = w.along[blocking] + at.t * w.twist[blocking];
    const double c = w.up[blocking] + at.tau * w.twist[blocking];
    if (c <= 0.0 || a == 0.0) return x;
    const double side = a > 0.0 ? -1.0 : 1.0;  // the way along this plane on which t grows
    if (go.tau != 0.0 && side * go.tau < 0.0) return x;
    go = {side, -side * a / c};
  }
  return x;
}

/// Where the ray at this tau leaves the solid, exactly.
double leaves_at(const ConvexScratch& w, double tau) {
  double t = infinity;
  for (std::size_t i = 0; i < w.rest.size(); ++i) {
    const double c = w.up[i] + tau * w.twist[i];
    if (c > 0.0) t = std::min(t, (w.rest[i] - tau * w.along[i]) / c);
  }
  return std::max(0.0, t);
}

}  // namespace

double depth_inside(const mesh::ConvexSolid& s, const Vec3& x_P) {
  double depth = infinity;
  for (std::size_t i = 0; i < s.b.size(); ++i)
    depth = std::min(depth, s.b[i] - (s.nx[i] * x_P.x() + s.ny[i] * x_P.y() + s.nz[i] * x_P.z()));
  return depth;
}

bool is_swept(const mesh::ConvexSolid& solid, const RelativePath& path, double depth,
              ConvexScratch& scratch) {
  const Interval tau = prepare(solid, path, depth, scratch);
  return tau.lo < tau.hi;
}

std::optional<double> exit_distance(const mesh::ConvexSolid& solid, const RelativePath& path,
                                    double depth, ConvexScratch& scratch) {
  const Interval tau = prepare(solid, path, depth, scratch);
  if (tau.lo >= tau.hi) return std::nullopt;
  prepare_directions(solid, path, scratch);
  const double middle = 0.5 * (tau.lo + tau.hi);
  Point top{middle, 0.0};
  constexpr int linearisations = 4;  // quadratic convergence: the turn of u in a step is small
  for (int k = 0; k < linearisations; ++k) {
    const Point next = climb(scratch, middle, top);
    const bool settled = next.tau == top.tau;
    top = next;
    if (settled) break;
  }
  return leaves_at(scratch, std::clamp(top.tau, 0.0, 1.0));
}

}  // namespace tdbd::rock
