#include "reference/rock/brute_force_exit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace tdbd::reference {
namespace {

struct Interval {
  double lo, hi;
};

/// Signed solid angle of triangle (a, b, c) seen from the origin (Van Oosterom and Strackee 1983).
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return 2.0 * std::atan2(a.dot(b.cross(c)), denominator);
}

/// The t at which the line q + t u crosses triangle (a, b, c); nothing if it misses or is parallel.
/// A hit on the rim counts (with slack for rounding), because a crossing that is found twice does
/// no harm below.
std::optional<double> crossing(const Vec3& q, const Vec3& u, const Vec3& a, const Vec3& b,
                               const Vec3& c) {
  constexpr double rim = 1e-9;
  Mat3 A;  // q + t u = a + beta (b - a) + gamma (c - a)
  A << -u, b - a, c - a;
  if (A.determinant() == 0.0) return std::nullopt;
  const Vec3 solution = A.inverse() * (q - a);
  const double beta = solution[1], gamma = solution[2];
  if (beta < -rim || gamma < -rim || beta + gamma > 1.0 + rim) return std::nullopt;
  return solution[0];
}

/// Sorted: 0 and all t > 0 at which the ray q + t u crosses the surface.
std::vector<double> crossings(const mesh::TriangleMesh& m, const Vec3& q, const Vec3& u) {
  std::vector<double> ts{0.0};
  for (const mesh::Triangle& f : m.triangles) {
    const auto t = crossing(q, u, m.positions[f[0]], m.positions[f[1]], m.positions[f[2]]);
    if (t && *t > 0.0) ts.push_back(*t);
  }
  std::sort(ts.begin(), ts.end());
  return ts;
}

/// The intervals of t >= 0 in which q + t u is inside. The state does not change between two
/// consecutive crossings, so the middle is tested.
std::vector<Interval> inside_intervals(const mesh::TriangleMesh& m, const Vec3& q, const Vec3& u) {
  const std::vector<double> ts = crossings(m, q, u);
  std::vector<Interval> intervals;
  for (std::size_t i = 0; i + 1 < ts.size(); ++i) {
    const double middle = 0.5 * (ts[i] + ts[i + 1]);
    if (ts[i] < ts[i + 1] && inside(m, q + middle * u)) intervals.push_back({ts[i], ts[i + 1]});
  }
  return intervals;
}

/// End of the connected component that starts at t = 0. Gaps up to `bridge` do not separate.
double end_of_first_component(std::vector<Interval> intervals, double bridge) {
  std::sort(intervals.begin(), intervals.end(),
            [](const Interval& a, const Interval& b) { return a.lo < b.lo; });
  double end = 0.0;
  for (const Interval& i : intervals) {
    if (i.lo > end + bridge) break;
    end = std::max(end, i.hi);
  }
  return end;
}

}  // namespace

bool inside(const mesh::TriangleMesh& closed, const Vec3& x) {
  double sum = 0.0;
  for (const mesh::Triangle& f : closed.triangles)
    sum += solid_angle(closed.positions[f[0]] - x, closed.positions[f[1]] - x,
                       closed.positions[f[2]] - x);
  return sum > 2.0 * std::numbers::pi;
}

SweptExit brute_force_exit(const mesh::TriangleMesh& part_P, const Vec3& q0_P, const Vec3& q1_P,
                           const Vec3& u0_P, const Vec3& u1_P, int substeps) {
  std::vector<Interval> all;
  bool swept = false;
  for (int k = 0; k <= substeps; ++k) {
    const double tau = static_cast<double>(k) / substeps;
    const Vec3 q_P = (1.0 - tau) * q0_P + tau * q1_P;
    const Vec3 u_P = (1.0 - tau) * u0_P + tau * u1_P;
    swept = swept || inside(part_P, q_P);
    for (const Interval& i : inside_intervals(part_P, q_P, u_P)) all.push_back(i);
  }
  if (!swept) return {};
  return {true, end_of_first_component(all, (q1_P - q0_P).norm() / substeps)};
}

}  // namespace tdbd::reference
