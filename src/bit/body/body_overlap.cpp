#include "bit/body/body_overlap.hpp"

#include <algorithm>
#include <array>

#include "core/compensated_sum.hpp"
#include "mesh/measures.hpp"
#include "mesh/shape/clip_convex.hpp"

namespace tdbd::bit {
namespace {

using Corners = std::array<Vec3, 3>;

mesh::Box box_of(const Corners& t) {
  mesh::Box box;
  for (const Vec3& x : t) box.add(x);
  return box;
}

/// Whether any point of the box can be vertically above the triangle, at smaller z.
bool stands_above(const mesh::Box& box, const mesh::Box& triangle) {
  return box.lo.x() < triangle.hi.x() && triangle.lo.x() < box.hi.x() &&
         box.lo.y() < triangle.hi.y() && triangle.lo.y() < box.hi.y() &&
         box.lo.z() < triangle.hi.z();
}

/// Signed volume of the part of a convex mesh that is vertically above a triangle whose normal has
/// n.z != 0.
double volume_above(mesh::TriangleMesh m, const Corners& t, const Vec3& n) {
  const double sign = n.z() > 0.0 ? 1.0 : -1.0;
  for (std::size_t k = 0; k < t.size() && !m.triangles.empty(); ++k) {
    const Vec3 edge = t[(k + 1) % t.size()] - t[k];
    const Vec3 out = sign * Vec3(edge.y(), -edge.x(), 0.0).normalized();
    m = mesh::clipped_convex(m, out, out.dot(t[k]));
  }
  if (m.triangles.empty()) return 0.0;
  const Vec3 down = sign * n.normalized();
  m = mesh::clipped_convex(m, down, down.dot(t[0]));
  return m.triangles.empty() ? 0.0 : mesh::enclosed_volume(m);
}

}  // namespace

double common_volume(const mesh::TriangleMesh& convex, const mesh::TriangleMesh& closed) {
  const mesh::Box box = mesh::bounding_box(convex);
  CompensatedSum sum;
  for (const mesh::Triangle& index : closed.triangles) {
    const Corners t{closed.positions[static_cast<std::size_t>(index[0])],
                    closed.positions[static_cast<std::size_t>(index[1])],
                    closed.positions[static_cast<std::size_t>(index[2])]};
    const Vec3 n = mesh::area_vector(t[0], t[1], t[2]);
    if (n.z() == 0.0 || !stands_above(box, box_of(t))) continue;
    sum.add(n.z() > 0.0 ? volume_above(convex, t, n) : -volume_above(convex, t, n));
  }
  return sum.value();
}

double cutters_in_body(const Bit& bit) {
  double volume = 0.0;
  for (const Part& body : bit.parts) {
    if (body.kind != PartKind::bit_body || body.density <= 0.0) continue;
    const mesh::TriangleMesh solid_B = mesh_B(body);
    for (const Part& part : bit.parts)
      if (part.cutter >= 0 && part.density > 0.0) volume += common_volume(mesh_B(part), solid_B);
  }
  return volume;
}

}  // namespace tdbd::bit
