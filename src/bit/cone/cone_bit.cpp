#include "bit/cone/cone_bit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bit/bit.hpp"
#include "bit/cone/cone_measures.hpp"
#include "bit/cone/cone_parts.hpp"
#include "core/types.hpp"

namespace tdbd::bit {
namespace {

Pose turn(double angle, const Vec3& axis) {
  return {Eigen::AngleAxisd(angle, axis).toRotationMatrix(), Vec3::Zero()};
}

Pose shift(const Vec3& by) { return {Mat3::Identity(), by}; }

}  // namespace

Pose cone_pose(const ConeLayout& c, double phi) {
  return turn(c.azimuth, Vec3::UnitZ()) * shift({0.0, c.offset, -c.foot_height}) *
         turn(c.skew, Vec3::UnitZ()) * turn(c.journal_angle - right_angle, Vec3::UnitY()) *
         shift({0.0, 0.0, c.apex}) * turn(phi, Vec3::UnitZ());
}

Pose cone_pose(const Cone& cone, double phi) { return cone.X_BK * turn(phi, Vec3::UnitZ()); }

Pose part_pose(const Bit& bit, const Part& part, const std::vector<double>& cone_angles) {
  if (part.cone < 0) return part.X_BP;
  const auto k = static_cast<std::size_t>(part.cone);
  return cone_pose(bit.cones[k], cone_angles.at(k)) * (inverse(bit.cones[k].X_BK) * part.X_BP);
}

Bit turned(Bit bit, const std::vector<double>& cone_angles) {
  for (Part& part : bit.parts) part.X_BP = part_pose(bit, part, cone_angles);
  return bit;
}

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

void set_tooth_directions(Bit& bit, GageRule rule) {
  for (Part& part : bit.parts) {
    if (part.kind != PartKind::tooth || part.row < 0) continue;
    const ConeLayout& cone = bit.cones[static_cast<std::size_t>(part.cone)].layout;
    direct(part, cone, cone.rows[static_cast<std::size_t>(part.row)], rule);
  }
}

namespace {

bool has_gage_row(const ConeLayout& cone) {
  return std::ranges::any_of(cone.rows,
                             [](const ToothRow& r) { return r.place == RowPlace::gage; });
}

/// The largest reach over all rows of a cone.
ConeReach rows_reach(const ConeLayout& cone) {
  const Pose X_BK = cone_pose(cone, 0.0);
  ConeReach all;
  all.depth = -1e300;
  for (const ToothRow& row : cone.rows) {
    const ConeReach one = reach_of(X_BK, row_meridian(cone, row));
    all.radius = std::max(all.radius, one.radius);
    all.depth = std::max(all.depth, one.depth);
  }
  return all;
}

/// Moves the cones along z so that the lowest tooth is at z = 0 of the bit. Returns the gage radius.
double settle(std::vector<ConeLayout>& cones, const std::string& name) {
  ConeReach all;
  all.depth = -1e300;
  for (const ConeLayout& cone : cones) {
    const ConeReach one = rows_reach(cone);
    all.radius = std::max(all.radius, one.radius);
    all.depth = std::max(all.depth, one.depth);
  }
  if (all.radius == 0.0) throw InputError(name + ": found no tooth, expected at least one");
  for (ConeLayout& cone : cones) cone.foot_height += all.depth;
  return all.radius;
}

void require_body_inside_gage(const Cone& cone, std::size_t index, double gage_radius) {
  const double radius = reach_of(cone.X_BK, shell_meridian(cone.layout.shell)).radius;
  if (radius > gage_radius)
    throw ConeBitError(
        index, "shell",
        fmt::format("a body that reaches {:.3f} mm from the bit's axis", 1e3 * radius),
        fmt::format("less than the teeth's {:.3f} mm (offset {:.4g} mm)", 1e3 * gage_radius,
                    1e3 * cone.layout.offset));
}

Part shank_part(const Shank& shank) {
  constexpr int segments = 48;
  Part body;
  body.name = "bit-body";
  body.kind = PartKind::bit_body;
  body.cutting = Cutting::never;
  body.mesh_P = surface_of_revolution({{0.0, -shank.height, 1},
                                       {shank.radius, -shank.height, segments},
                                       {shank.radius, -shank.height - shank.length, segments},
                                       {0.0, -shank.height - shank.length, 1}});
  for (Vec3& x : body.mesh_P.positions) x = Vec3(x.y(), x.z(), x.x());  // rings are about X
  body.density = shank.density;
  return body;
}

}  // namespace

ConeBitError::ConeBitError(std::size_t of_cone, std::string of_key, std::string was,
                           std::string wanted)
    : InputError(
          fmt::format("cone-{}: {}: found {}, expected {}", of_cone + 1, of_key, was, wanted)),
      cone(of_cone),
      key(std::move(of_key)),
      found(std::move(was)),
      expected(std::move(wanted)) {}

Bit cone_bit(std::string name, std::vector<ConeLayout> cones, std::optional<double> gage_radius,
             const Shank& shank) {
  Bit bit;
  bit.name = std::move(name);
  bit.shank = shank;
  for (std::size_t k = 0; k < cones.size(); ++k) {
    if (!gage_radius || !has_gage_row(cones[k])) continue;
    try {
      cones[k].apex = apex_for_gage(cones[k], *gage_radius);
    } catch (const InputError& e) {
      throw ConeBitError(k, "offset", e.what(), "an offset and a size of the cone for it");
    }
  }
  bit.gage_radius = settle(cones, bit.name);
  for (ConeLayout& layout : cones) {
    const int index = static_cast<int>(bit.cones.size());
    const Pose X_BK = cone_pose(layout, 0.0);
    bit.cones.push_back({fmt::format("cone-{}", index + 1), std::move(layout), X_BK});
    require_body_inside_gage(bit.cones.back(), bit.cones.size() - 1, bit.gage_radius);
    for (Part& part : cone_parts(bit.cones.back(), index)) bit.parts.push_back(std::move(part));
  }
  set_tooth_directions(bit, GageRule::normal);
  if (shank.radius > 0.0) bit.parts.push_back(shank_part(shank));
  return bit;
}

}  // namespace tdbd::bit
