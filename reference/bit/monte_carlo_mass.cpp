#include "reference/bit/monte_carlo_mass.hpp"

#include <cmath>

#include "core/random.hpp"

namespace tdbd::reference {
namespace {

/// Twice the signed area of the triangle o, a, b, projected along x.
double turn(const Vec3& o, const Vec3& a, const Vec3& b) {
  return (a.y() - o.y()) * (b.z() - o.z()) - (a.z() - o.z()) * (b.y() - o.y());
}

bool ray_meets(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const double u = turn(p, b, c), v = turn(p, c, a), w = turn(p, a, b);
  const bool within = (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
  return within && (u * a.x() + v * b.x() + w * c.x()) / (u + v + w) > p.x();
}

bool inside(const mesh::TriangleMesh& m, const Vec3& p) {
  bool odd = false;
  for (const mesh::Triangle& t : m.triangles)
    if (ray_meets(p, m.positions[t[0]], m.positions[t[1]], m.positions[t[2]])) odd = !odd;
  return odd;
}

/// Standard error of the mean of n values, from their sum and sum of squares.
double error_of_mean(double sum, double squares, double n) {
  const double mean = sum / n;
  return std::sqrt(std::max(0.0, squares / n - mean * mean) / n);
}

}  // namespace

EstimatedMass monte_carlo_mass(const mesh::TriangleMesh& m, long points, std::uint64_t seed) {
  Vec3 lo = m.positions.front(), hi = lo;
  for (const Vec3& x : m.positions) {
    lo = lo.cwiseMin(x);
    hi = hi.cwiseMax(x);
  }
  Random random{seed};
  double hits = 0.0;
  Vec3 x_sum = Vec3::Zero(), x_squares = Vec3::Zero();
  Mat3 j_sum = Mat3::Zero(), j_squares = Mat3::Zero();
  for (long k = 0; k < points; ++k) {
    Vec3 p;
    for (int i = 0; i < 3; ++i) p[i] = random.uniform(lo[i], hi[i]);
    if (!inside(m, p)) continue;
    const Mat3 j = p.squaredNorm() * Mat3::Identity() - p * p.transpose();
    hits += 1.0;
    x_sum += p;
    x_squares += p.cwiseProduct(p);
    j_sum += j;
    j_squares += j.cwiseProduct(j);
  }
  const double n = static_cast<double>(points), box = (hi - lo).prod();
  EstimatedMass e{
      box * hits / n, box * error_of_mean(hits, hits, n), box / n * x_sum, {}, box / n * j_sum, {}};
  for (int i = 0; i < 3; ++i) {
    e.first_error[i] = box * error_of_mean(x_sum[i], x_squares[i], n);
    for (int k = 0; k < 3; ++k)
      e.inertia_error(i, k) = box * error_of_mean(j_sum(i, k), j_squares(i, k), n);
  }
  return e;
}

}  // namespace tdbd::reference
