#include "bit/cone/cone_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bit/cone/cone_shell.hpp"
#include "bit/cone/tooth_mesh.hpp"
#include "core/angles.hpp"

namespace tdbd::bit {
namespace {

Part cone_body(const Cone& cone, int index) {
  Part body;
  body.name = cone.name + "/body";
  body.kind = PartKind::cone;
  body.cutting = cone.layout.body;
  body.X_BP = cone.X_BK;
  body.mesh_P = shell_mesh(cone.layout);
  body.pieces_P = shell_pieces(cone.layout);
  body.density = cone.layout.density;
  body.cone = index;
  return body;
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
    const mesh::TriangleMesh mesh_T = tooth_mesh(row.shape, cone.layout.facets);
    for (std::size_t i = 0; i < row.angles.size(); ++i) {
      Part& tooth = parts.emplace_back();
      tooth.name = fmt::format("{}/row-{}/tooth-{}", cone.name, row_number, i + 1);
      tooth.kind = PartKind::tooth;
      tooth.X_BP = cone.X_BK * tooth_pose(cone.layout, row, row.angles[i]);
      tooth.mesh_P = mesh_T;
      tooth.density = row.shape.density;
      tooth.cone = index;
      tooth.row = row_number - 1;
    }
  }
  return parts;
}

Meridian row_meridian(const ConeLayout& cone, const ToothRow& row) {
  return swept_meridian(tooth_mesh(row.shape, cone.facets), tooth_pose(cone, row, 0.0));
}

std::vector<double> spaced_angles(int teeth, double first_angle,
                                  const std::vector<double>& pattern) {
  const auto ratio = [&](int i) {
    return pattern.empty() ? 1.0 : pattern[static_cast<std::size_t>(i) % pattern.size()];
  };
  double sum = 0.0;
  for (int i = 0; i < teeth; ++i) sum += ratio(i);
  std::vector<double> angles;
  double passed = 0.0;
  for (int i = 0; i < teeth; ++i) {
    const double angle = first_angle + full_turn * passed / sum;
    const double turned = angle - full_turn * std::floor(angle / full_turn);
    angles.push_back(turned < full_turn ? turned : 0.0);
    passed += ratio(i);
  }
  std::ranges::sort(angles);
  return angles;
}

}  // namespace tdbd::bit
