#include "bit/body/enclosed_parts.hpp"

#include <algorithm>
#include <optional>

#include "mesh/measures.hpp"
#include "mesh/search/inside.hpp"

namespace tdbd::bit {
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
