#include "reference/rock/close_surface.hpp"

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

/// The boundary vertices, in the direction in which the triangles traverse them.
std::vector<int> boundary_loop(const mesh::TriangleMesh& m) {
  std::set<std::pair<int, int>> edges;
  for (const mesh::Triangle& f : m.triangles)
    for (int i = 0; i < 3; ++i) edges.emplace(f[i], f[(i + 1) % 3]);
  std::map<int, int> next;
  for (const auto& [a, b] : edges)
    if (!edges.contains({b, a}) && !next.emplace(a, b).second)
      throw RunError("close_surface: the boundary passes a vertex twice");
  if (next.empty()) throw RunError("close_surface: the surface has no boundary");
  std::vector<int> loop{next.begin()->first};
  while (next.at(loop.back()) != loop.front()) loop.push_back(next.at(loop.back()));
  if (loop.size() != next.size()) throw RunError("close_surface: the boundary is not one loop");
  return loop;
}

void check_room(const mesh::TriangleMesh& m, const std::vector<int>& loop, double bottom) {
  for (const int v : loop)
    if (m.positions[v].z() != m.positions[loop.front()].z())
      throw RunError("close_surface: the boundary is not level");
  for (const Vec3& x : m.positions)
    if (x.z() >= bottom) throw RunError("close_surface: the surface reaches below the bottom");
}

}  // namespace

mesh::TriangleMesh close_surface(const mesh::TriangleMesh& open, double depth) {
  const std::vector<int> loop = boundary_loop(open);
  const double bottom = open.positions[loop.front()].z() + depth;
  check_room(open, loop, bottom);

  mesh::TriangleMesh block = open;
  const int n = static_cast<int>(loop.size());
  const int below = static_cast<int>(open.positions.size()), centre = below + n;
  Vec3 mean = Vec3::Zero();
  for (const int v : loop) {
    const Vec3& x = open.positions[v];
    block.positions.push_back({x.x(), x.y(), bottom});
    mean += block.positions.back() / n;
  }
  block.positions.push_back({mean.x(), mean.y(), bottom});

  for (int i = 0; i < n; ++i) {  // neighbours traverse a common edge in opposite directions
    const int a = loop[i], b = loop[(i + 1) % n], a_below = below + i,
              b_below = below + (i + 1) % n;
    block.triangles.push_back({b, a, a_below});
    block.triangles.push_back({b, a_below, b_below});
    block.triangles.push_back({b_below, a_below, centre});
  }
  return block;
}

}  // namespace tdbd::reference
