#include "bit/cone/tooth_prints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bit/cone/cone_parts.hpp"
#include "bit/cone/tooth_mesh.hpp"

namespace tdbd::bit {
namespace {

constexpr double pi = std::numbers::pi, two_pi = 2.0 * pi;

/// The angle about the cone's Z at which a point of the cone is deepest.
double deepest_angle_of(const Cone& cone) {
  const Vec3 down_K = cone.X_BK.R.transpose() * Vec3::UnitZ();
  return std::atan2(down_K.y(), down_K.x());
}

Vec3 tip_B(const Cone& cone, const ToothRow& row, double angle) {
  return cone.X_BK * (tooth_pose(cone.layout, row, angle) * Vec3(0.0, 0.0, row.shape.protrusion));
}

/// Extent along a direction of the part of a convex mesh that is deeper than `depth` (z).
struct Extent {
  double depth;
  Vec3 along;
  double lo = std::numeric_limits<double>::infinity(), hi = -lo;

  void add(const Vec3& x) {
    lo = std::min(lo, along.dot(x));
    hi = std::max(hi, along.dot(x));
  }
  void add_edge(const Vec3& a, const Vec3& b) {
    if (a.z() >= depth) add(a);
    if ((a.z() >= depth) != (b.z() >= depth)) add(a + (depth - a.z()) / (b.z() - a.z()) * (b - a));
  }
};

}  // namespace

double print_width(const Cone& cone, const ToothRow& row, double penetration) {
  const double angle = deepest_angle_of(cone);
  const Pose X_BT = cone.X_BK * tooth_pose(cone.layout, row, angle);
  const mesh::TriangleMesh mesh_T = tooth_mesh(row.shape, cone.layout.facets);
  std::vector<Vec3> x_B;
  x_B.reserve(mesh_T.positions.size());
  double deepest = -std::numeric_limits<double>::infinity();
  for (const Vec3& x_T : mesh_T.positions)
    deepest = std::max(deepest, x_B.emplace_back(X_BT * x_T).z());
  const Vec3 tip = tip_B(cone, row, angle);
  const Vec3 across = Vec3::UnitZ().cross(Vec3(tip.x(), tip.y(), 0.0));
  if (across.norm() == 0.0) return 0.0;
  Extent extent{deepest - penetration, across.normalized()};
  for (const mesh::Triangle& t : mesh_T.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      extent.add_edge(x_B[static_cast<std::size_t>(t[k])],
                      x_B[static_cast<std::size_t>(t[(k + 1) % 3])]);
  return extent.hi - extent.lo;
}

PrintRing print_ring(const Cone& cone, const ToothRow& row, double penetration) {
  PrintRing ring;
  ring.deepest_angle = deepest_angle_of(cone);
  const Vec3 tip = tip_B(cone, row, ring.deepest_angle);
  ring.radius = tip.head<2>().norm();
  ring.azimuth_B = std::atan2(tip.y(), tip.x());
  ring.angles = row.angles;
  ring.width = print_width(cone, row, penetration);
  return ring;
}

std::vector<Print> prints(const PrintRing& ring, double speed_ratio, double from, double to) {
  std::vector<Print> all;
  for (const double angle : ring.angles) {
    const double first = (angle - ring.deepest_angle) / speed_ratio;
    const double pitch = two_pi / speed_ratio;
    const auto begin = static_cast<long>(std::ceil((from - first) / pitch));
    const auto end = static_cast<long>(std::ceil((to - first) / pitch));
    for (long m = begin; m < end; ++m) {
      const double turned = first + pitch * static_cast<double>(m);
      all.push_back({turned, turned + ring.azimuth_B});
    }
  }
  std::ranges::sort(all, {}, &Print::turned);
  return all;
}

double tooth_contact_ratio(const Cone& cone, const ToothRow& row, double penetration) {
  const Vec3 tip_K = tooth_pose(cone.layout, row, 0.0) * Vec3(0.0, 0.0, row.shape.protrusion);
  const double height = std::abs(tip_K.x()) * cone.X_BK.R.row(2).head<2>().norm();
  const double cosine = height > 0.0 ? std::max(-1.0, 1.0 - penetration / height) : -1.0;
  return static_cast<double>(row.angles.size()) * std::acos(cosine) / pi;
}

}  // namespace tdbd::bit
