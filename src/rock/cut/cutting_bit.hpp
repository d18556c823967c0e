#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/simd.hpp"
#include "mesh/measures.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "mesh/shape/convex.hpp"
#include "rock/cut/convex_union.hpp"
#include "rock/cut/plane_sectors.hpp"
#include "rock/index/vertex_grid.hpp"

namespace tdbd::rock {

/// A part, or a convex piece of one, prepared for swept queries. A convex part is represented by
/// its planes, any other part by a tree over its facets.
struct CuttingPart {
  int part = -1;  ///< index into Bit::parts
  std::string name;
  mesh::ConvexSolid solid_P;                 ///< without planes if there is a tree
  std::optional<mesh::TriangleTree> tree_P;  ///< only if there are no planes
  double depth = 0.0;     ///< m, smallest depth of a sweep (tolerance::swept times size)
  std::size_t slot = 0;   ///< index among the solids of the group (SweptScratch)
  double checksum = 0.0;  ///< of solid_P (plane_strip.hpp)
  double share = 1.0;     ///< bit::Part::share
};

/// All parts of a group as one convex solid.
struct CuttingUnion {
  CuttingPart solid;   ///< a copy of the group's first part, with the planes of the whole
  FacetOwners claims;  ///< owners of those planes' facets, as indices of the group's parts
  /// Sectors of the solid, shared by equal solids; null if it has none.
  std::shared_ptr<const PlaneSectors> sectors = nullptr;
};

/// The axis about which update directions are rotated (thesis 4.1.2.3) when the bit leans.
/// `upright`: the axis of the hole, so that rock moves down the hole. `bit`: the axis of the bit,
/// as in the thesis, in which the bit does not lean.
enum class DirectionFrame { upright, bit };

/// Planes of a solid in single precision, padded with planes at infinity to a multiple of `run`.
struct SingleSolid {
  static constexpr std::size_t most = 40, run = 8;
  std::size_t planes = 0;
  std::array<Single, most> nx{}, ny{}, nz{}, b{};
};

/// Parts of the bit, or rock that breaks out beside a face (section/breakout.hpp).
enum class GroupKind { parts, breakout };

/// A group that is `away` removes no rock.
enum class GroupActivity { there, away };

/// How much of the rock in its way a group leaves: nothing, or the remaining share if a part
/// removes less than all of it (CuttingPart::share).
enum class Residue { nothing, share_only };

/// Parts with the same frame and update direction. The search treats them together; the moves are
/// made part by part.
struct CuttingGroup {
  Pose X_BP;
  mesh::Box box_P;
  mesh::ConvexSolid hull_P;  ///< a few planes around all parts, including those of box_P
  SingleSolid single_hull_P;
  double radius = 0.0;    ///< m, of a cylinder about x around all parts; 0: too loose
  double reach = 0.0;     ///< m, largest distance from the bit's axis
  double distance = 0.0;  ///< m, largest distance from the bit's origin
  Vec3 update_direction_B;
  std::vector<CuttingPart> parts;
  std::optional<bit::Segment> core_P;  ///< bit::Part::core_P
  Pose X_BP1;  ///< at the end of the step (X_BP: at its start); they differ if a cone turns
  DirectionFrame directions = DirectionFrame::bit;
  /// Set if exits are computed from the whole and the union of the parts is convex.
  std::optional<CuttingUnion> whole = std::nullopt;
  GroupKind kind = GroupKind::parts;
  GroupActivity presence = GroupActivity::there;
  Residue leaves = Residue::nothing;
};

/// The cutting parts, in the order in which they remove rock (the bit's order).
struct CuttingBit {
  std::vector<CuttingGroup> groups;
  int part_count = 0;  ///< number of parts of the whole bit
  double size = 0.0;   ///< m, diameter over the cutting parts; scale of tolerance::inside
};

/// How a vertex leaves a group. `parts`: it leaves the parts one after another, and each part is
/// credited with its own share of the volume. `whole`: if the parts fill a convex solid, the vertex
/// leaves that solid at once, and the part through whose surface it leaves is credited with the
/// whole volume.
enum class ExitFrom { parts, whole };

struct CuttingOptions {
  DirectionFrame directions = DirectionFrame::bit;
  ExitFrom exit_from = ExitFrom::whole;
};

/// Prepares every cutting part from its closed mesh (bit::Part).
CuttingBit prepare_cutting_bit(const bit::Bit& bit, const CuttingOptions& options = {});

/// Sets the poses of the cones' parts for a step. `from`, `to`: angles of each cone at its
/// beginning and end, rad.
void turn_cones(CuttingBit& cutting, const bit::Bit& bit, const std::vector<double>& from,
                const std::vector<double>& to);

/// Poses of one group during a step, and derived quantities.
struct GroupMotion {
  Pose X_PW0, X_PW1;
  /// Frame D of the update directions at pose 1: the bit's frame or, if directions are upright and
  /// the bit leans, axes parallel to those of W at the bit's origin. Its rotation about z does not
  /// matter.
  Pose X_DW1;
  Mat3 R_WD1, R_DB;
  double reach_W;   ///< m, no point of the group sweeps farther from the z axis of W
  Region region_W;  ///< bounds of the group's box at both poses, axis-aligned and oriented
  Pose X_WP0, X_WP1;
};

/// Computes the motion of a group. Thesis: 4.1.1.
GroupMotion group_motion(const CuttingGroup& g, const Pose& X_WB0, const Pose& X_WB1);

/// Whether the whole group stays closer to the hole's axis than all rock at its heights.
inline bool is_out_of_reach(const VertexGrid& grid, const GroupMotion& m) {
  return grid.nearest_to_axis(m.region_W.box.lo.z(), m.region_W.box.hi.z()) > m.reach_W;
}

}  // namespace tdbd::rock
