#include "benchmarks/block.hpp"

#include <map>

#include "reference/rock/close_surface.hpp"

namespace tdbd::bench {
namespace {

/// The open surface with a ring of triangles around its mouth.
mesh::TriangleMesh with_top(const mesh::Surface& hole_W, double radius) {
  const mesh::TriangleMesh m = mesh::compact(hole_W);
  const mesh::Surface s = mesh::make_surface(m);
  mesh::TriangleMesh wide = m;
  std::map<int, int> outside;  // from a vertex of the mouth to the vertex beside it on the rim
  const auto beside = [&](int v) {
    const auto [place, is_new] = outside.try_emplace(v, static_cast<int>(wide.positions.size()));
    if (is_new) {
      const Vec3& x = s.position(v);
      const double scale = radius / x.head<2>().norm();
      wide.positions.push_back({scale * x.x(), scale * x.y(), x.z()});
    }
    return place->second;
  };
  for (int c = 0; c < 3 * s.triangle_slots(); ++c) {
    if (s.opposite_of(c) >= 0) continue;
    const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
    const int a_out = beside(a), b_out = beside(b);
    wide.triangles.push_back({b, a, a_out});
    wide.triangles.push_back({b, a_out, b_out});
  }
  return wide;
}

}  // namespace

mesh::TriangleMesh block_of_rock(const mesh::Surface& hole_W, double radius, double depth) {
  return reference::close_surface(with_top(hole_W, radius), depth);
}

}  // namespace tdbd::bench
