#include "rock/maintain/trim.hpp"

#include <algorithm>

#include "core/compensated_sum.hpp"
#include "mesh/edit.hpp"

namespace tdbd::rock {
namespace {

bool is_above(const mesh::Surface& s, int t, double z_W) {
  const mesh::Triangle& v = s.triangles[at(t)];
  return std::ranges::all_of(v, [&](int i) { return s.position(i).z() < z_W; });
}

/// Triangles above the plane at boundary vertices, in ascending order.
void find_first(const Rock& rock, double from_z_W, double z_W, TrimWorkspace& work) {
  constexpr double everywhere = 1e300;
  Region slab_W;
  slab_W.box = {Vec3(-everywhere, -everywhere, from_z_W), Vec3(everywhere, everywhere, z_W)};
  work.vertices.clear();
  rock.grid.visit(slab_W, work.chains, [&](const VertexGrid::Block& block) {
    for (int i = 0; i < block.count; ++i) {
      const int v = block.v[at(i)];
      if (rock.surface.is_boundary(v) && rock.surface.position(v).z() < z_W)
        work.vertices.push_back(v);
    }
  });
  std::sort(work.vertices.begin(), work.vertices.end());
  work.triangles.clear();
  for (const int v : work.vertices)
    mesh::visit_corners(rock.surface, v, [&](int c) { work.triangles.push_back(c / 3); });
}

double six_hole_volumes(const mesh::Surface& s, int t) {
  const mesh::Triangle& v = s.triangles[at(t)];
  return -s.position(v[0]).dot(s.position(v[1]).cross(s.position(v[2])));
}

/// Removes one triangle and queues the triangles at its corners.
void remove(Rock& rock, int t, TrimWorkspace& work) {
  const mesh::Triangle corners = rock.surface.triangles[at(t)];
  const int gone = mesh::remove_triangle(rock.surface, t);
  if (gone >= 0) rock.grid.remove(gone);
  for (const int v : corners) discard_ring_note(rock, v);
  for (const int v : corners)
    if (v != gone)
      mesh::visit_corners(rock.surface, v, [&](int c) { work.triangles.push_back(c / 3); });
}

}  // namespace

void trim_wall(Rock& rock, double from_z_W, double z_W, TrimWorkspace& work, TrimReport& report) {
  find_first(rock, from_z_W, z_W, work);
  CompensatedSum six_volumes;
  for (std::size_t i = 0; i < work.triangles.size(); ++i) {
    const int t = work.triangles[i];
    if (!rock.surface.triangle_is_alive(t) || !is_above(rock.surface, t, z_W)) continue;
    if (!mesh::removal_keeps_disc(rock.surface, t)) continue;
    six_volumes.add(six_hole_volumes(rock.surface, t));
    remove(rock, t, work);
    ++report.triangles;
  }
  report.volume += six_volumes.value() / 6.0;
}

}  // namespace tdbd::rock
