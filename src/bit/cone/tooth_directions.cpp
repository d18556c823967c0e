#include "bit/cone/tooth_directions.hpp"

#include <algorithm>
#include <cmath>

#include "bit/cone/cone_parts.hpp"

namespace tdbd::bit {
namespace {

/// The outward and downward part of the row's normal at the place where the row is farthest from
/// the bit's axis, in the journal's plane.
Vec3 row_direction(const ConeLayout& cone, const ToothRow& row) {
  const double down = cone.journal_angle;
  const Pose X_KT = tooth_pose(cone, row, 0.0);
  const Vec3 z_K = X_KT.R.col(2);  // y = 0
  const double out = z_K.x() * std::sin(down) - z_K.z() * std::cos(down);
  const double deep = z_K.x() * std::cos(down) + z_K.z() * std::sin(down);
  const Vec3 u(std::max(0.0, out), 0.0, std::max(0.0, deep));
  return u.norm() > 0.0 ? Vec3(u.normalized()) : Vec3(Vec3::UnitZ());
}

Segment core_of(const ToothShape& shape) {
  const double top = std::max(-shape.embedding, shape.protrusion - 0.5 * shape.diameter);
  return {Vec3(0.0, 0.0, -shape.embedding), Vec3(0.0, 0.0, top)};
}

void direct(Part& tooth, const ConeLayout& cone, const ToothRow& row, GageRule rule) {
  tooth.core_P.reset();
  tooth.update_direction_B = Vec3::UnitZ();
  if (row.place == RowPlace::inner || rule == GageRule::down) return;
  tooth.update_direction_B =
      rule == GageRule::horizontal ? Vec3(Vec3::UnitX()) : row_direction(cone, row);
  if (rule == GageRule::normal) tooth.core_P = core_of(row.shape);
}

}  // namespace

void direct_teeth(Bit& bit, GageRule rule) {
  for (Part& part : bit.parts) {
    if (part.kind != PartKind::tooth || part.row < 0) continue;
    const ConeLayout& cone = bit.cones[static_cast<std::size_t>(part.cone)].layout;
    direct(part, cone, cone.rows[static_cast<std::size_t>(part.row)], rule);
  }
}

}  // namespace tdbd::bit
