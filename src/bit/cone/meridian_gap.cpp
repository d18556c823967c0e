#include "bit/cone/meridian_gap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

#include "core/angles.hpp"

namespace tdbd::bit {
namespace {

/// A patch of A's surface: a piece of one side of the meridian and an interval of angles.
struct Patch {
  std::size_t side;
  double along, half_along;  ///< in [0, 1] of the side
  double angle, half_angle;  ///< rad
  double least;              ///< m, lower bound of the distance of the patch from B

  bool operator<(const Patch& p) const { return least > p.least; }  // smallest first
};

struct Search {
  const Meridian& a;
  const Meridian& b;
  Pose X_BA_in_B;  ///< A's frame in B's
  Gap best{std::numeric_limits<double>::infinity(), {}, 0.0};

  const ShellPoint& start(std::size_t side) const { return a[side]; }
  const ShellPoint& end(std::size_t side) const { return a[(side + 1) % a.size()]; }

  /// Measures the middle of a patch and bounds its other points.
  void measure(Patch& p) {
    const ShellPoint &from = start(p.side), &to = end(p.side);
    const ShellPoint at{from.s + p.along * (to.s - from.s), from.r + p.along * (to.r - from.r)};
    const Vec3 x = X_BA_in_B * Vec3(at.r * std::cos(p.angle), at.r * std::sin(p.angle), -at.s);
    const double distance = signed_distance(b, {-x.z(), std::hypot(x.x(), x.y())});
    if (distance < best.distance) best = {distance, at, p.angle};
    const double slide = p.half_along * std::hypot(to.s - from.s, to.r - from.r);
    p.least = distance - slide - (at.r + slide) * p.half_angle;
  }

  /// Bisects the patch in its longer direction.
  std::pair<Patch, Patch> halves(const Patch& p) const {
    const ShellPoint &from = start(p.side), &to = end(p.side);
    const double length = p.half_along * std::hypot(to.s - from.s, to.r - from.r);
    const double arc = p.half_angle * std::max(from.r, to.r);
    Patch lo = p, hi = p;
    double Patch::*const middle = length > arc ? &Patch::along : &Patch::angle;
    double Patch::*const half = length > arc ? &Patch::half_along : &Patch::half_angle;
    lo.*half = hi.*half = 0.5 * (p.*half);
    lo.*middle -= lo.*half;
    hi.*middle += hi.*half;
    return {lo, hi};
  }
};

}  // namespace

Gap smallest_gap(const Meridian& a, const Pose& X_BA, const Meridian& b, const Pose& X_BB,
                 double tolerance, double enough) {
  Search search{a, b, inverse(X_BB) * X_BA};
  std::priority_queue<Patch> patches;
  const auto add = [&](Patch p) {
    search.measure(p);
    patches.push(p);
  };
  for (std::size_t side = 0; side < a.size(); ++side) add({side, 0.5, 0.5, pi, pi, 0.0});
  for (long looked_at = 0; !patches.empty(); ++looked_at) {
    const Patch p = patches.top();
    patches.pop();
    if (p.least >= search.best.distance - tolerance || p.least >= enough) break;
    if (looked_at == most_patches) {
      search.best.is_exact = false;
      break;
    }
    const auto [lo, hi] = search.halves(p);
    add(lo);
    add(hi);
  }
  return search.best;
}

}  // namespace tdbd::bit
