#include "bit/body/bit_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "bit/surface_of_revolution.hpp"
#include "core/compensated_sum.hpp"
#include "mesh/measures.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "mesh/shape/convex.hpp"

namespace tdbd::bit {
namespace {

constexpr int body_segments = 48;
constexpr double gage_length = 0.06;     ///< m, of full body above the highest tip
constexpr double shank_radius = 0.7;     ///< times the gage radius
constexpr double shank_length = 1.0;     ///< times the gage radius
constexpr double least_ring_gap = 1e-3;  ///< m, between two points of the meridian

/// Cutters of the profile, without back-ups, from the axis to the gage.
std::vector<Cutter> along_profile(std::vector<Cutter> cutters) {
  if (std::ranges::count(cutters, 0.0, &Cutter::under_exposure) > 0)
    std::erase_if(cutters, [](const Cutter& c) { return c.under_exposure > 0.0; });
  std::ranges::sort(cutters, {},
                    [](const Cutter& c) { return std::tuple(c.tip_radius, c.tip_height); });
  return cutters;
}

/// A ring about the bit's axis: x of a Ring is z of the bit.
Ring set_back(const Cutter& c, double setback) {
  const double depth = setback * c.diameter;
  return {c.tip_radius - depth * std::sin(c.profile_angle),
          -c.tip_height - depth * std::cos(c.profile_angle), body_segments};
}

/// The meridian under the cutters. If the profile is flat at the axis, the first cutter's slope is
/// kept.
std::vector<Ring> face_meridian(const std::vector<Cutter>& ordered, double setback) {
  const Ring first = set_back(ordered.front(), setback);
  const double slope = std::tan(std::clamp(ordered.front().profile_angle, -0.8, 0.0));
  std::vector<Ring> rings{{0.0, first.x + slope * first.radius, 1}};
  for (const Cutter& c : ordered) {
    const Ring next = set_back(c, setback);
    if (std::hypot(next.radius - rings.back().radius, next.x - rings.back().x) > least_ring_gap &&
        next.radius >= rings.back().radius)
      rings.push_back(next);
  }
  return rings;
}

/// Rotates rings about X to rings about the bit's z. A cyclic exchange of axes preserves the
/// orientation.
mesh::TriangleMesh about_z(mesh::TriangleMesh m) {
  for (Vec3& p : m.positions) p = Vec3(p.y(), p.z(), p.x());
  return m;
}

}  // namespace

Part bit_body(const std::vector<Cutter>& cutters, double setback, double density,
              double gage_radius) {
  std::vector<Ring> rings = face_meridian(along_profile(cutters), setback);
  const double highest_tip = std::ranges::max(cutters, {}, &Cutter::tip_height).tip_height;
  const double shoulder = -highest_tip - gage_length;
  const double end = shoulder - shank_length * gage_radius;
  rings.push_back({rings.back().radius, shoulder, body_segments});
  rings.push_back({shank_radius * gage_radius, shoulder, body_segments});
  rings.push_back({shank_radius * gage_radius, end, body_segments});
  rings.push_back({0.0, end, 1});
  Part body;
  body.name = "bit-body";
  body.kind = PartKind::bit_body;
  body.cutting = Cutting::never;
  body.mesh_P = about_z(surface_of_revolution(rings));
  body.density = density;
  return body;
}

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

namespace {

bool encloses(const mesh::Box& outer, const mesh::Box& inner) {
  return outer.contains(inner.lo) && outer.contains(inner.hi);
}

}  // namespace

std::vector<std::pair<int, int>> enclosed_parts(const Bit& bit) {
  std::vector<mesh::TriangleMesh> meshes;
  std::vector<mesh::Box> boxes;
  for (const Part& part : bit.parts) {
    meshes.push_back(mesh_B(part));
    boxes.push_back(mesh::bounding_box(meshes.back()));
  }
  std::vector<std::optional<mesh::TriangleTree>> trees(meshes.size());
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < meshes.size(); ++i)
    for (std::size_t o = 0; o < meshes.size(); ++o) {
      const bool weigh = bit.parts[i].density > 0.0 && bit.parts[o].density > 0.0;
      if (i == o || !weigh || !encloses(boxes[o], boxes[i])) continue;
      if (!trees[o]) trees[o].emplace(meshes[o]);
      if (std::ranges::all_of(meshes[i].positions,
                              [&](const Vec3& x) { return mesh::inside(*trees[o], x); }))
        pairs.emplace_back(static_cast<int>(i), static_cast<int>(o));
    }
  return pairs;
}

}  // namespace tdbd::bit
