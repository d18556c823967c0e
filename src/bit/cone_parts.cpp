#include "bit/cone_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bit/cone_shell.hpp"
#include "bit/tooth_mesh.hpp"

namespace tdbd::bit {
namespace {

Part cone_body(const Cone& cone, int index) {
  Part body;
  body.name = cone.name + "/body";
  body.kind = PartKind::cone;
  body.cutting = Cutting::never;
  body.X_BP = cone.X_BK;
  body.mesh_P = shell_mesh(cone.layout);
  body.density = cone.layout.density;
  body.cone = index;
  return body;
}

/// Outward and down of the normal of the row where it is farthest from the bit's axis: its meridian
/// plane is that of the journal.
Vec3 gage_direction(const Cone& cone, const ToothRow& row) {
  const double down = cone.layout.journal_angle;
  const Pose X_KT = tooth_pose(cone.layout, row, 0.0);
  const Vec3 z_K = X_KT.R.col(2);  // y = 0
  const double out = z_K.x() * std::sin(down) - z_K.z() * std::cos(down);
  const double deep = z_K.x() * std::cos(down) + z_K.z() * std::sin(down);
  const Vec3 u(std::max(0.0, out), 0.0, std::max(0.0, deep));
  return u.norm() > 0.0 ? Vec3(u.normalized()) : Vec3(Vec3::UnitZ());
}

}  // namespace

Pose tooth_pose(const ConeLayout& cone, const ToothRow& row, double angle) {
  const ShellPlace at = shell_place(cone.shell, row.s);
  const double turn = std::atan2(at.normal.s, at.normal.r) + row.lean;
  const Vec3 z(std::cos(turn), 0.0, -std::sin(turn)), x(-std::sin(turn), 0.0, -std::cos(turn));
  Pose X_KT;
  X_KT.R << x, z.cross(x), z;
  X_KT.p = Vec3(at.point.r - row.sink * at.normal.r, 0.0, -at.point.s + row.sink * at.normal.s);
  return Pose{Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix(), Vec3::Zero()} * X_KT;
}

std::vector<Part> cone_parts(const Cone& cone, int index) {
  std::vector<Part> parts{cone_body(cone, index)};
  int row_number = 0;
  for (const ToothRow& row : cone.layout.rows) {
    ++row_number;
    const Vec3 direction_B =
        row.place == RowPlace::gage ? gage_direction(cone, row) : Vec3(Vec3::UnitZ());
    const mesh::TriangleMesh mesh_T = tooth_mesh(row.shape, cone.layout.facets);
    for (std::size_t i = 0; i < row.angles.size(); ++i) {
      Part& tooth = parts.emplace_back();
      tooth.name = fmt::format("{}/row-{}/tooth-{}", cone.name, row_number, i + 1);
      tooth.kind = PartKind::tooth;
      tooth.X_BP = cone.X_BK * tooth_pose(cone.layout, row, row.angles[i]);
      tooth.mesh_P = mesh_T;
      tooth.update_direction_B = direction_B;
      tooth.density = row.shape.density;
      tooth.cone = index;
    }
  }
  return parts;
}

Meridian row_meridian(const ConeLayout& cone, const ToothRow& row) {
  return swept_meridian(tooth_mesh(row.shape, cone.facets), tooth_pose(cone, row, 0.0));
}

}  // namespace tdbd::bit
