#include "mesh/measures.hpp"

#include <cmath>

#include "core/compensated_sum.hpp"

namespace tdbd::mesh {

double triangle_quality(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double edges2 = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return edges2 > 0.0 ? 4.0 * std::sqrt(3.0) * area_vector(a, b, c).norm() / edges2 : 0.0;
}

double enclosed_volume(const TriangleMesh& m) {
  CompensatedSum six_volumes;
  if (m.positions.empty()) return 0.0;
  const Vec3& o = m.positions.front();
  for (const Triangle& t : m.triangles) {
    const Vec3 a = m.positions[t[0]] - o, b = m.positions[t[1]] - o, c = m.positions[t[2]] - o;
    six_volumes.add(a.dot(b.cross(c)));
  }
  return six_volumes.value() / 6.0;
}

double area(const TriangleMesh& m) {
  CompensatedSum sum;
  for (const Triangle& t : m.triangles)
    sum.add(area_vector(m.positions[t[0]], m.positions[t[1]], m.positions[t[2]]).norm());
  return sum.value();
}

Box bounding_box(const TriangleMesh& m) {
  Box box;
  for (const Vec3& x : m.positions) box.add(x);
  return box;
}

}  // namespace tdbd::mesh
