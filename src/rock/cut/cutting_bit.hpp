#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/single.hpp"
#include "mesh/measures.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "mesh/shape/convex.hpp"
#include "rock/cut/convex_union.hpp"
#include "rock/cut/facet_walk.hpp"
#include "rock/cut/plane_sectors.hpp"

namespace tdbd::rock {

/// A part, or a convex piece of one, prepared for swept queries. A convex part is represented by
/// its planes, any other part by a tree over its facets.
struct CuttingPart {
  int part = -1;  ///< index into Bit::parts
  std::string name;
  mesh::ConvexSolid solid_P;                 ///< without planes if there is a tree
  std::optional<mesh::TriangleTree> tree_P;  ///< only if there are no planes
  FacetNeighbours across;                    ///< of the tree's facets; empty: no walks
  double depth = 0.0;     ///< m, smallest depth of a sweep (tolerance::swept times size)
  std::size_t slot = 0;   ///< index among the solids of the group (SweptScratch)
  double checksum = 0.0;  ///< of solid_P (near_planes.hpp)
  double share = 1.0;     ///< bit::Part::share
};

/// All parts of a group as one convex solid.
struct CuttingWhole {
  CuttingPart solid;  ///< a copy of the group's first part, with the planes of the whole
  Claims claims;      ///< owners of those planes' facets, as indices of the group's parts
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
enum class GroupPresence { there, away };

/// How much of the rock in its way a group leaves: nothing, or the remaining share if a part
/// removes less than all of it (CuttingPart::share).
enum class Leaves { nothing, a_share };

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
  std::optional<CuttingWhole> whole = std::nullopt;
  GroupKind kind = GroupKind::parts;
  GroupPresence presence = GroupPresence::there;
  Leaves leaves = Leaves::nothing;
};

/// The cutting parts, in the order in which they remove rock (the bit's order).
struct CuttingBit {
  std::vector<CuttingGroup> groups;
  int part_count = 0;  ///< number of parts of the whole bit
  double size = 0.0;   ///< m, diameter over the cutting parts; scale of tolerance::inside
};

/// Search for exits from parts that are not convex (swept_mesh.hpp). Both give the same results.
enum class ExitSearch { tree, walk };

/// How a vertex leaves a group. `parts`: it leaves the parts one after another, and each part is
/// credited with its own share of the volume. `whole`: if the parts fill a convex solid, the vertex
/// leaves that solid at once, and the part through whose surface it leaves is credited with the
/// whole volume.
enum class ExitFrom { parts, whole };

struct CuttingOptions {
  ExitSearch search = ExitSearch::tree;
  DirectionFrame directions = DirectionFrame::bit;
  ExitFrom exit_from = ExitFrom::whole;
};

/// Prepares every cutting part from its closed mesh (bit::Part).
CuttingBit prepare_cutting_bit(const bit::Bit& bit, const CuttingOptions& options = {});

/// Sets the poses of the cones' parts for a step. `from`, `to`: angles of each cone at its
/// beginning and end, rad.
void turn_cones(CuttingBit& cutting, const bit::Bit& bit, const std::vector<double>& from,
                const std::vector<double>& to);

}  // namespace tdbd::rock
