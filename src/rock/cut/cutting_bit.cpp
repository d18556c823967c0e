#include "rock/cut/cutting_bit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bit/cone/cone_bit.hpp"
#include "core/tolerance.hpp"
#include "rock/cut/plane_strip.hpp"

namespace tdbd::rock {
namespace {

constexpr std::size_t sides_of_box = 6;

CuttingPart prepare_solid(const bit::Part& part, const mesh::TriangleMesh& mesh_P, int index) {
  CuttingPart prepared{index, part.name, {}, {}, {}};
  prepared.depth = tolerance::swept * mesh::bounding_box(mesh_P).size().norm();
  if (auto solid = mesh::convex_solid(mesh_P)) {
    prepared.solid_P = spread_planes(*solid, solid->planes);
    prepared.checksum = checksum(prepared.solid_P);
  } else
    prepared.tree_P.emplace(mesh_P);
  prepared.share = part.share;
  return prepared;
}

/// Adds a part as one solid or, if its convex pieces are known, as several.
void add_part(CuttingGroup& group, const bit::Part& part, int index) {
  const auto add = [&](const mesh::TriangleMesh& mesh_P) {
    group.parts.push_back(prepare_solid(part, mesh_P, index));
    group.parts.back().slot = group.parts.size() - 1;
  };
  if (part.pieces_P.empty()) add(part.mesh_P);
  for (const mesh::TriangleMesh& piece_P : part.pieces_P) add(piece_P);
}

bool same_planes(const mesh::ConvexSolid& a, const mesh::ConvexSolid& b) {
  return a.nx == b.nx && a.ny == b.ny && a.nz == b.nz && a.b == b.b;
}

/// Limit on a group's solids: each has a bit in a 64-bit mask (Excluded).
constexpr std::size_t most_solids = 63;

bool same_group(const bit::Bit& bit, const CuttingGroup& group, const bit::Part& part) {
  return part.group >= 0 && group.parts.size() + part.pieces_P.size() < most_solids &&
         bit.parts[at(group.parts.front().part)].group == part.group;
}

/// Returns the sectors of the whole, shared with an equal cutter if there is one.
std::shared_ptr<const PlaneSectors> sectors_of(const CuttingPart& solid, double size,
                                               const CuttingBit& others) {
  for (const CuttingGroup& g : others.groups)
    if (g.whole && g.whole->sectors && g.whole->sectors->size == size &&
        g.whole->solid.checksum == solid.checksum &&
        same_planes(g.whole->solid.solid_P, solid.solid_P))
      return g.whole->sectors;
  PlaneSectors made = plane_sectors(solid.solid_P, size);
  return made.sectors.empty() ? nullptr : std::make_shared<const PlaneSectors>(std::move(made));
}

/// Returns the group as one solid if it has several parts and they fill a convex solid.
std::optional<CuttingUnion> whole_of(const CuttingGroup& g, const bit::Bit& bit) {
  std::vector<ConvexPart> pieces;
  for (const CuttingPart& part : g.parts) {
    const bit::Part& source = bit.parts[at(part.part)];
    if (part.tree_P || !source.pieces_P.empty()) return std::nullopt;
    pieces.push_back({part.solid_P, source.mesh_P});
  }
  auto shape = pieces.size() > 1 ? convex_union(pieces) : std::nullopt;
  if (!shape) return std::nullopt;
  CuttingUnion whole{g.parts.front(), std::move(shape->claims)};
  whole.solid.solid_P = std::move(shape->solid_P);
  whole.solid.checksum = checksum(whole.solid.solid_P);
  whole.solid.slot = g.parts.size();
  whole.solid.depth = tolerance::swept * g.box_P.size().norm();
  return whole;
}

/// The largest distance of x from the bit's origin over all turns of the part's cone.
double largest_distance(const bit::Bit& bit, const bit::Part& part, const Vec3& x_P) {
  const Pose& X_BK = bit.cones[at(part.cone)].X_BK;
  return X_BK.p.norm() + (part.X_BP * x_P - X_BK.p).norm();
}

/// The sides of the box, and the planes of single parts that bound all other parts, too.
mesh::ConvexSolid bounding_planes(const CuttingGroup& g, const bit::Bit& bit) {
  mesh::ConvexSolid planes;
  for (int i = 0; i < 3; ++i) {
    mesh::add_plane(planes, Vec3::Unit(i), g.box_P.hi[i]);
    mesh::add_plane(planes, -Vec3::Unit(i), -g.box_P.lo[i]);
  }
  const double slack = tolerance::convex * g.box_P.size().norm();
  for (const CuttingPart& part : g.parts)
    for (std::size_t i = 0; i < part.solid_P.planes; ++i) {
      const Vec3 n = mesh::normal(part.solid_P, i);
      double support = part.solid_P.b[i];
      for (const CuttingPart& other : g.parts)
        for (const Vec3& x_P : bit.parts[at(other.part)].mesh_P.positions)
          support = std::max(support, n.dot(x_P));
      if (support <= part.solid_P.b[i] + slack) mesh::add_plane(planes, n, support);
    }
  return planes;
}

/// Radius of the cylinder about the x axis of P around all parts; 0 if it is much wider than their
/// box. Includes tolerance::convex, because the planes of a convex part may lie outside its corners
/// by that much.
double radius_of_round(const CuttingGroup& g, const bit::Bit& bit) {
  constexpr double looseness = 1.1;
  double radius = 0.0;
  for (const CuttingPart& part : g.parts)
    for (const Vec3& x_P : bit.parts[at(part.part)].mesh_P.positions)
      radius = std::max(radius, x_P.tail<2>().norm());
  const Vec3 size = g.box_P.size();
  const bool is_round = 2.0 * radius <= looseness * std::min(size.y(), size.z());
  return is_round ? radius + tolerance::convex * size.norm() : 0.0;
}

/// The sides of the box come last because the box is tested separately before the planes.
SingleSolid in_single(const mesh::ConvexSolid& planes) {
  SingleSolid single;
  single.planes = planes.planes;
  single.b.fill(std::numeric_limits<Single>::infinity());
  for (std::size_t i = 0; i < planes.planes; ++i) {
    const std::size_t k = (i + sides_of_box) % planes.planes;
    single.nx[i] = static_cast<Single>(planes.nx[k]);
    single.ny[i] = static_cast<Single>(planes.ny[k]);
    single.nz[i] = static_cast<Single>(planes.nz[k]);
    single.b[i] = static_cast<Single>(planes.b[k]);
  }
  return single;
}

}  // namespace

CuttingBit prepare_cutting_bit(const bit::Bit& bit, const CuttingOptions& options) {
  CuttingBit cutting;
  cutting.part_count = static_cast<int>(bit.parts.size());
  mesh::Box box_B;
  for (int i = 0; i < cutting.part_count; ++i) {
    const bit::Part& part = bit.parts[at(i)];
    if (part.cutting != bit::Cutting::cuts) continue;
    if (cutting.groups.empty() || !same_group(bit, cutting.groups.back(), part))
      cutting.groups.push_back({part.X_BP,
                                {},
                                {},
                                {},
                                0.0,
                                0.0,
                                0.0,
                                part.update_direction_B,
                                {},
                                part.core_P,
                                part.X_BP});
    CuttingGroup& group = cutting.groups.back();
    add_part(group, part, i);
    if (part.share < 1.0) group.leaves = Residue::share_only;
    for (const Vec3& x_P : part.mesh_P.positions) {
      group.box_P.add(x_P);
      const Vec3 x_B = part.X_BP * x_P;
      box_B.add(x_B);
      const double turned = part.cone < 0 ? 0.0 : largest_distance(bit, part, x_P);
      group.reach = std::max({group.reach, x_B.head<2>().norm(), turned});
      group.distance = std::max({group.distance, x_B.norm(), turned});
    }
  }
  for (CuttingGroup& group : cutting.groups) {
    group.hull_P = spread_planes(bounding_planes(group, bit), SingleSolid::most);
    group.single_hull_P = in_single(group.hull_P);
    group.radius = radius_of_round(group, bit);
    group.directions = options.directions;
    if (options.exit_from == ExitFrom::whole) group.whole = whole_of(group, bit);
    if (group.whole)
      group.whole->sectors = sectors_of(group.whole->solid, group.box_P.size().norm(), cutting);
  }
  cutting.size = std::max(box_B.size().x(), box_B.size().y());
  return cutting;
}

void turn_cones(CuttingBit& cutting, const bit::Bit& bit, const std::vector<double>& from,
                const std::vector<double>& to) {
  for (CuttingGroup& group : cutting.groups) {
    const bit::Part& part = bit.parts[at(group.parts.front().part)];
    if (part.cone < 0) continue;
    group.X_BP = bit::part_pose(bit, part, from);
    group.X_BP1 = bit::part_pose(bit, part, to);
  }
}

namespace {

/// Bounds of the box at both poses: axis-aligned planes, and planes normal to the box's own axes at
/// pose 1.
Region moving_box(const mesh::Box& box_P, const Pose& X_WP0, const Pose& X_WP1) {
  const Vec3 middle_P = 0.5 * (box_P.lo + box_P.hi), half = 0.5 * box_P.size();
  const Vec3 c0_W = X_WP0 * middle_P, c1_W = X_WP1 * middle_P;
  const Vec3 half0_W = X_WP0.R.cwiseAbs() * half, half1_W = X_WP1.R.cwiseAbs() * half;
  Region r;
  r.box = {(c0_W - half0_W).cwiseMin(c1_W - half1_W), (c0_W + half0_W).cwiseMax(c1_W + half1_W)};
  const Mat3 R_P1W = X_WP1.R.transpose();
  const Vec3 half0 = (R_P1W * X_WP0.R).cwiseAbs() * half, c0 = R_P1W * c0_W, c1 = R_P1W * c1_W;
  for (int i = 0; i < 3; ++i)
    r.slabs[at(i)] = {X_WP1.R.col(i), std::min(c0[i] - half0[i], c1[i] - half[i]),
                      std::max(c0[i] + half0[i], c1[i] + half[i])};
  return r;
}

/// Upper bound of the distance from the hole's axis. The chord of a rotation is nearer to the axis
/// than its ends by the cosine of half the angle. A tilted axis shifts a point by at most the tilt
/// times its distance from the origin; this is counted for the part and for the rock beside it.
double reach(const CuttingGroup& g, const Pose& X_WB0, const Pose& X_WB1) {
  const double cosine = 0.5 * ((X_WB0.R.transpose() * X_WB1.R).trace() - 1.0);
  const double half_turn = std::sqrt(std::max(0.0, 0.5 * (1.0 + cosine)));
  double off_axis = 0.0;
  for (const Pose* X_WB : {&X_WB0, &X_WB1}) {
    const double tilt = (X_WB->R.col(2) - Vec3::UnitZ()).norm();
    off_axis = std::max(off_axis, X_WB->p.head<2>().norm() + 4.0 * tilt * g.distance);
  }
  return half_turn > 0.5 ? g.reach / half_turn + off_axis : INFINITY;
}

Pose direction_frame(const CuttingGroup& g, const Pose& X_WB) {
  const bool leans = X_WB.R.col(2) != Vec3::UnitZ();
  return leans && g.directions == DirectionFrame::upright ? Pose{Mat3::Identity(), X_WB.p} : X_WB;
}

}  // namespace

GroupMotion group_motion(const CuttingGroup& g, const Pose& X_WB0, const Pose& X_WB1) {
  const Pose X_WP0 = X_WB0 * g.X_BP, X_WP1 = X_WB1 * g.X_BP1, X_WD1 = direction_frame(g, X_WB1);
  const bool is_bit = X_WD1.R == X_WB1.R;
  return {inverse(X_WP0),
          inverse(X_WP1),
          inverse(X_WD1),
          X_WD1.R,
          is_bit ? Mat3(Mat3::Identity()) : Mat3(X_WD1.R.transpose() * X_WB1.R),
          reach(g, X_WB0, X_WB1),
          moving_box(g.box_P, X_WP0, X_WP1),
          X_WP0,
          X_WP1};
}

}  // namespace tdbd::rock
