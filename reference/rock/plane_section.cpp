#include "reference/rock/plane_section.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::reference {

PlaneSection plane_section(const mesh::TriangleMesh& convex_P, const Pose& X_WP) {
  std::vector<Vec3> points;
  for (const mesh::Triangle& t : convex_P.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = X_WP * convex_P.positions[at(t[k])],
                 b = X_WP * convex_P.positions[at(t[(k + 1) % 3])];
      if ((a.z() > 0.0) != (b.z() > 0.0)) points.push_back(a + a.z() / (a.z() - b.z()) * (b - a));
    }
  Vec3 mean = Vec3::Zero();
  for (const Vec3& x : points) mean += x / static_cast<double>(points.size());
  const auto direction = [&](const Vec3& x) {
    return std::atan2(x.y() - mean.y(), x.x() - mean.x());
  };
  std::ranges::sort(points, {}, direction);
  PlaneSection s;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec3 a = points[k] - mean, b = points[(k + 1) % points.size()] - mean;
    const double area = 0.5 * (a.x() * b.y() - a.y() * b.x());
    s.area += area;
    s.centroid += area * (mean + (a + b) / 3.0);
  }
  if (s.area > 0.0) s.centroid /= s.area;
  return s;
}

}  // namespace tdbd::reference
