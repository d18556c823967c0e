#include "bit/cone/cone_bit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bit/cone/cone_frame.hpp"
#include "bit/cone/cone_parts.hpp"
#include "bit/cone/cone_reach.hpp"
#include "bit/cone/tooth_directions.hpp"
#include "bit/surface_of_revolution.hpp"
#include "core/error.hpp"

namespace tdbd::bit {
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

/// Moves the cones along z to the bit's origin and returns the gage radius.
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
  direct_teeth(bit, GageRule::normal);
  if (shank.radius > 0.0) bit.parts.push_back(shank_part(shank));
  return bit;
}

}  // namespace tdbd::bit
