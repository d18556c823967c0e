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

/// A part, or a convex piece of one, prepared for swept queries: by its planes if it is convex,
/// otherwise by a tree over its facets.
struct CuttingPart {
  int part = -1;  ///< index into Bit::parts
  std::string name;
  mesh::ConvexSolid solid_P;                 ///< no planes if there is a tree
  std::optional<mesh::TriangleTree> tree_P;  ///< only without planes
  FacetNeighbours across;                    ///< of the tree's facets; empty: exits without walks
  double depth = 0.0;    ///< m: shallower than this is not swept (tolerance::swept times part size)
  std::size_t slot = 0;  ///< its number among the solids of the group (SweptScratch)
  double checksum = 0.0;  ///< of solid_P (near_planes.hpp)
  double share = 1.0;     ///< bit::Part::share
};

/// The parts of a group as one convex solid.
struct CuttingWhole {
  CuttingPart solid;  ///< a copy of the group's first part with the planes of all
  Claims claims;      ///< by the group's parts, on those planes
  /// Of the solid, shared by equal ones; none: it has none.
  std::shared_ptr<const PlaneSectors> sectors = nullptr;
};

/// The axis about which update directions turn (thesis 4.1.2.3) when the bit leans: the hole's, so
/// that rock goes down the hole, or the bit's own, as in the thesis, where the bit does not lean.
enum class DirectionFrame { upright, bit };

/// Planes of a solid in single precision, padded to whole runs with planes at infinity.
struct SingleSolid {
  static constexpr std::size_t most = 40, run = 8;
  std::size_t planes = 0;
  std::array<Single, most> nx{}, ny{}, nz{}, b{};
};

/// Parts of the bit, or rock that breaks out beside a face (section/breakout.hpp).
enum class GroupKind { parts, breakout };

/// A group that is away takes no rock.
enum class GroupPresence { there, away };

/// What a group leaves of the rock in its way: nothing, or, if a part removes less than all
/// (CuttingPart::share), the rest of what that part meets.
enum class Leaves { nothing, a_share };

/// Parts that share a frame and an update direction: searched for together, processed one by one.
struct CuttingGroup {
  Pose X_BP;
  mesh::Box box_P;
  mesh::ConvexSolid hull_P;  ///< a few planes around all parts, including those of box_P
  SingleSolid single_hull_P;
  double radius = 0.0;    ///< m, of a cylinder about the x axis around all parts; 0: a loose one
  double reach = 0.0;     ///< m, farthest from the bit's axis
  double distance = 0.0;  ///< m, farthest from the bit's origin
  Vec3 update_direction_B;
  std::vector<CuttingPart> parts;
  std::optional<bit::Segment> core_P;  ///< bit::Part::core_P
  Pose X_BP1;  ///< at the end of the step (X_BP: at its start); they differ where a cone turns
  DirectionFrame directions = DirectionFrame::bit;
  /// If exits are from the whole and the union of the parts is convex.
  std::optional<CuttingWhole> whole = std::nullopt;
  GroupKind kind = GroupKind::parts;
  GroupPresence presence = GroupPresence::there;
  Leaves leaves = Leaves::nothing;
};

/// The parts that cut, in the order in which they take rock (the bit's order).
struct CuttingBit {
  std::vector<CuttingGroup> groups;
  int part_count = 0;  ///< of the whole bit
  double size = 0.0;   ///< m, diameter over the cutting parts: scale of tolerance::inside
};

/// How exits from parts that are not convex are found (swept_mesh.hpp); both give the same.
enum class ExitSearch { tree, walk };

/// Whether a vertex leaves the parts of a group one after another, so that each has its own share
/// of the volume, or, where the parts fill a convex solid, that at once: then the part through which
/// it leaves has the whole volume.
enum class ExitFrom { parts, whole };

struct CuttingOptions {
  ExitSearch search = ExitSearch::tree;
  DirectionFrame directions = DirectionFrame::bit;
  ExitFrom exit_from = ExitFrom::whole;
};

/// Prepares every part that cuts, from its closed mesh (bit::Part).
CuttingBit prepare_cutting_bit(const bit::Bit& bit, const CuttingOptions& options = {});

/// Turns the cones in a step: from the first angles to the second (rad, one for each cone).
void turn_cones(CuttingBit& cutting, const bit::Bit& bit, const std::vector<double>& from,
                const std::vector<double>& to);

}  // namespace tdbd::rock
