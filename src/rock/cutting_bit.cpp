#include "rock/cutting_bit.hpp"

#include <algorithm>

#include "core/tolerance.hpp"

namespace tdbd::rock {
namespace {

CuttingPart prepare_part(const bit::Part& part, int index) {
  CuttingPart prepared{index, part.name, {}, {}, 0.0};
  prepared.depth = tolerance::swept * mesh::bounding_box(part.mesh_P).size().norm();
  if (auto solid = mesh::convex_solid(part.mesh_P))
    prepared.solid_P = std::move(*solid);
  else
    prepared.tree_P.emplace(part.mesh_P);
  return prepared;
}

bool same_group(const bit::Bit& bit, const CuttingGroup& group, const bit::Part& part) {
  return part.group >= 0 &&
         bit.parts[static_cast<std::size_t>(group.parts.front().part)].group == part.group;
}

}  // namespace

CuttingBit prepare_cutting_bit(const bit::Bit& bit) {
  CuttingBit cutting;
  cutting.part_count = static_cast<int>(bit.parts.size());
  mesh::Box box_B;
  for (int i = 0; i < cutting.part_count; ++i) {
    const bit::Part& part = bit.parts[static_cast<std::size_t>(i)];
    if (part.cutting == bit::Cutting::never) continue;
    if (cutting.groups.empty() || !same_group(bit, cutting.groups.back(), part))
      cutting.groups.push_back({part.X_BP, {}, part.update_direction_B, {}});
    CuttingGroup& group = cutting.groups.back();
    group.parts.push_back(prepare_part(part, i));
    for (const Vec3& x_P : part.mesh_P.positions) {
      group.box_P.add(x_P);
      box_B.add(part.X_BP * x_P);
    }
  }
  cutting.size = std::max(box_B.size().x(), box_B.size().y());
  return cutting;
}

}  // namespace tdbd::rock
