#include "reference/mesh/hausdorff.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tdbd::reference {
namespace {

double distance_to_segment(const Vec3& x, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double length2 = ab.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((x - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
  return (x - (a + t * ab)).norm();
}

/// Triangles in square bins of the x-y plane.
class Bins {
 public:
  Bins(const mesh::TriangleMesh& m, double half, double size)
      : mesh_(m),
        half_(half),
        size_(size),
        n_(static_cast<int>(2.0 * half / size) + 1),
        bins_(n_ * n_) {
    for (const mesh::Triangle& t : m.triangles) {
      Vec3 lo = m.positions[t[0]], hi = lo;
      for (const int v : t) {
        lo = lo.cwiseMin(m.positions[v]);
        hi = hi.cwiseMax(m.positions[v]);
      }
      for (int j = along(lo.y()); j <= along(hi.y()); ++j)
        for (int i = along(lo.x()); i <= along(hi.x()); ++i) bins_[j * n_ + i].push_back(t);
    }
  }

  /// Distance to the nearest triangle. Searches rings of bins outwards until no nearer one can
  /// exist. Stops at any distance up to `enough`, because only the largest distance of all points
  /// is needed.
  double distance(const Vec3& x, double enough) const {
    const int i = along(x.x()), j = along(x.y());
    double best = INFINITY;
    for (int ring = 0; ring < n_ && (ring - 1) * size_ < best && best > enough; ++ring)
      for (int dj = -ring; dj <= ring; ++dj)
        for (int di = -ring; di <= ring; di += std::abs(dj) == ring ? 1 : std::max(2 * ring, 1))
          best = std::min(best, within(x, i + di, j + dj, enough));
    return best;
  }

 private:
  int along(double x) const { return std::clamp(static_cast<int>((x + half_) / size_), 0, n_ - 1); }

  double within(const Vec3& x, int i, int j, double enough) const {
    double best = INFINITY;
    if (i < 0 || j < 0 || i >= n_ || j >= n_) return best;
    const std::vector<Vec3>& p = mesh_.positions;
    for (const auto& [a, b, c] : bins_[j * n_ + i]) {
      best = std::min(best, distance_to_triangle(x, p[a], p[b], p[c]));
      if (best <= enough) break;
    }
    return best;
  }

  const mesh::TriangleMesh& mesh_;
  double half_, size_;
  int n_;
  std::vector<std::vector<mesh::Triangle>> bins_;
};

}  // namespace

double distance_to_triangle(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a);
  const auto beside = [&](const Vec3& p, const Vec3& q) {
    return n.dot((q - p).cross(x - p)) >= 0.0;
  };
  if (n.squaredNorm() > 0.0 && beside(a, b) && beside(b, c) && beside(c, a))
    return std::abs(n.dot(x - a)) / n.norm();
  return std::min(
      {distance_to_segment(x, a, b), distance_to_segment(x, b, c), distance_to_segment(x, c, a)});
}

double one_sided_hausdorff(const mesh::TriangleMesh& from, const mesh::TriangleMesh& to,
                           const HausdorffSampling& sampling) {
  const Bins bins(to, sampling.half, 4.0 * sampling.spacing);
  const std::vector<Vec3>& p = from.positions;
  double worst = 0.0;
  for (const auto& [a, b, c] : from.triangles) {
    const double longest =
        std::max({(p[b] - p[a]).norm(), (p[c] - p[b]).norm(), (p[a] - p[c]).norm()});
    const int n = 1 + static_cast<int>(longest / sampling.spacing);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const Vec3 x = p[a] + (p[b] - p[a]) * (static_cast<double>(i) / n) +
                       (p[c] - p[a]) * (static_cast<double>(j) / n);
        if (std::max(std::abs(x.x()), std::abs(x.y())) <= sampling.half)
          worst = std::max(worst, bins.distance(x, worst));
      }
  }
  return worst;
}

double hausdorff(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b,
                 const HausdorffSampling& sampling) {
  return std::max(one_sided_hausdorff(a, b, sampling), one_sided_hausdorff(b, a, sampling));
}

}  // namespace tdbd::reference
