#include "mesh/measures.hpp"

#include <cmath>
#include <utility>

#include "core/compensated_sum.hpp"
#include "mesh/surface.hpp"

namespace tdbd::mesh {
namespace {

double squared_distance_to_segment(const Vec3& a, const Vec3& b, const Vec3& x) {
  const Vec3 e = b - a;
  const double length2 = e.squaredNorm();
  const double s = length2 > 0.0 ? std::clamp(e.dot(x - a) / length2, 0.0, 1.0) : 0.0;
  return (x - a - s * e).squaredNorm();
}

}  // namespace

double squared_distance(const Facet& f, const Vec3& x) {
  const Vec3 n = (f.b - f.a).cross(f.c - f.a);
  const auto foot = meet(f, x, n);
  if (foot && foot->margin >= 0.0) return foot->s * foot->s * n.squaredNorm();
  return std::min({squared_distance_to_segment(f.a, f.b, x),
                   squared_distance_to_segment(f.b, f.c, x),
                   squared_distance_to_segment(f.c, f.a, x)});
}

namespace {

QualityStatistics summarize(std::vector<double> qualities) {
  if (qualities.empty()) return {};
  const auto one_percent = qualities.begin() + static_cast<std::ptrdiff_t>(qualities.size() / 100);
  std::nth_element(qualities.begin(), one_percent, qualities.end());
  return {*std::min_element(qualities.begin(), one_percent + 1), *one_percent};
}

}  // namespace

double triangle_quality(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double edges2 = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return edges2 > 0.0 ? 4.0 * std::sqrt(3.0) * area_vector(a, b, c).norm() / edges2 : 0.0;
}

QualityStatistics quality_statistics(const TriangleMesh& m) {
  std::vector<double> qualities;
  qualities.reserve(m.triangles.size());
  for (const Triangle& t : m.triangles)
    qualities.push_back(
        triangle_quality(m.positions[at(t[0])], m.positions[at(t[1])], m.positions[at(t[2])]));
  return summarize(std::move(qualities));
}

QualityStatistics quality_statistics(const Surface& s) {
  std::vector<double> qualities;
  for (const Triangle& t : s.triangles)
    if (t[0] >= 0)
      qualities.push_back(triangle_quality(s.position(t[0]), s.position(t[1]), s.position(t[2])));
  return summarize(std::move(qualities));
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
