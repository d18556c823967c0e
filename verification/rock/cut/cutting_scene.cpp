#include "verification/rock/cut/cutting_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/measures.hpp"
#include "rotation/screw.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock {
namespace {

using battery::integer;
using battery::number;
using mesh::TriangleMesh;

TriangleMesh any_shape() {
  const double size = *number(0.1, 0.4);
  switch (*integer(0, 2)) {
    case 0:
      return battery::placed({size * Mat3::Identity(), Vec3::Zero()},
                             *battery::convex_polyhedron());
    case 1:
      return battery::box(-size * Vec3(1, *number(0.05, 1.0), 0.7), size * Vec3(1, 0.5, 0.5));
    default:
      return battery::cylinder(size, *number(0.05, 0.3), *integer(3, 20));
  }
}

Vec3 any_update_direction(double outwards) {
  if (*integer(0, 2) == 0) return Vec3::UnitZ();
  const double angle = *number(0.0, outwards);
  return Vec3(std::sin(angle), 0.0, std::cos(angle));
}

/// Every other part, by chance, joins the group (pose and direction) of the one before.
bit::Bit any_bit(const Wildness& w) {
  bit::Bit bit;
  const int parts = *integer(1, w.most_parts);
  for (int i = 0; i < parts; ++i) {
    bit::Part p;
    p.name = "part-" + std::to_string(i);
    p.mesh_P = any_shape();
    p.group = i;
    p.X_BP = *battery::pose(0.3);
    p.update_direction_B = any_update_direction(w.outwards);
    if (i > 0 && *rc::gen::arbitrary<bool>()) {
      const bit::Part& before = bit.parts.back();
      p.group = before.group;
      p.X_BP = before.X_BP;
      p.update_direction_B = before.update_direction_B;
    }
    bit.parts.push_back(std::move(p));
  }
  return bit;
}

}  // namespace

rc::Gen<Scene> scene(const Wildness& w) {
  return rc::gen::exec([w] {
    Scene s;
    s.bit = any_bit(w);
    const Vec3 tilt(*number(-w.tilt, w.tilt), *number(-w.tilt, w.tilt), 0.0);
    const double spin = *number(-3.0, 3.0), turn = *number(-w.turn, w.turn);
    s.X_WB0 = {rotation::exp(tilt) * rotation::exp(Vec3(0, 0, spin)), *battery::point(0.1)};
    s.X_WB1 = {s.X_WB0.R * rotation::exp(Vec3(0, 0, turn)), s.X_WB0.p + *battery::point(0.15)};
    s.rock_W =
        battery::bumpy_rock(1.0, *integer(6, 20), w.bump, *rc::gen::arbitrary<std::uint64_t>());
    for (Vec3& x : s.rock_W.positions) x.head<2>() *= 1.5;  // the parts' reach, and a margin
    return s;
  });
}

Rock rock_of(const Scene& s) {
  return make_rock(mesh::make_surface(s.rock_W), 0.2, mesh::bounding_box(s.rock_W));
}

double depth_behind_triangles(const TriangleMesh& convex, const Vec3& x) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : convex.triangles) {
    const Vec3& p = convex.positions[a];
    const Vec3 n = mesh::area_vector(p, convex.positions[b], convex.positions[c]);
    if (n.norm() > 0.0) least = std::min(least, n.normalized().dot(p - x));
  }
  return least;
}

}  // namespace tdbd::rock
