#include "simulation/study/hole.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include "mesh/search/surface_distance.hpp"
#include "mesh/surface.hpp"

namespace tdbd::simulation {
namespace {

double median_edge(const mesh::TriangleMesh& m) {
  if (m.triangles.empty()) return 0.0;
  std::vector<double> lengths;
  for (const mesh::Triangle& t : m.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      lengths.push_back((m.positions[at(t[i])] - m.positions[at(t[(i + 1) % 3])]).norm());
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

double radius(const mesh::TriangleMesh& m) {
  mesh::Box box;
  for (const mesh::Triangle& t : m.triangles)
    for (const int v : t) box.add(m.positions[at(v)]);
  return m.triangles.empty() ? 0.0 : 0.5 * std::max(box.size().x(), box.size().y());
}

}  // namespace

Hole hole_of(const rock::Rock& rock) {
  std::vector<int> slots;
  Hole hole{mesh::compact(rock.surface, &slots), {}};
  hole.cut.positions = hole.rock.positions;
  const auto is_moved = [&](int v) { return rock.last_part[at(slots[at(v)])] >= 0; };
  std::ranges::copy_if(hole.rock.triangles, std::back_inserter(hole.cut.triangles),
                       [&](const mesh::Triangle& t) { return std::ranges::any_of(t, is_moved); });
  hole.edge = median_edge(hole.cut);
  return hole;
}

HoleDifference difference(const Hole& a, const Hole& b) {
  if (a.cut.triangles.empty() && b.cut.triangles.empty()) return {};
  const double edge =
      a.edge > 0.0 && b.edge > 0.0 ? std::min(a.edge, b.edge) : std::max(a.edge, b.edge);
  const mesh::SurfaceDistance there = distance_to(a.cut, mesh::TriangleTree(b.rock), 0.5 * edge),
                              back = distance_to(b.cut, mesh::TriangleTree(a.rock), 0.5 * edge);
  return {std::max(there.largest, back.largest), 0.5 * (there.volume + back.volume),
          std::max(radius(a.cut), radius(b.cut))};
}

}  // namespace tdbd::simulation
