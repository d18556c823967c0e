#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "bit/bit.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "mesh/shape/convex.hpp"
#include "rock/cut/cut_rock.hpp"
#include "rock/rock.hpp"
#include "rock/section/box_sides.hpp"
#include "rock/section/contact_area.hpp"
#include "rock/section/underside.hpp"

namespace tdbd::rock {

/// A part that rubs: rock may be inside it, since it moves none. Prepared once, by its planes if it is
/// convex, otherwise by a tree over its facets.
struct RubbingPart {
  /// All rock vertices are farther than underside_P.room from the part turned about its axis at X_WP.
  struct Clear {
    long changes = -1;  ///< of the rock's index that this includes; -1: not known to be clear
    Pose X_WP;
  };
  int part = -1;  ///< index into Bit::parts
  mesh::Box box_P;
  mesh::ConvexSolid solid_P;                 ///< no planes if there is a tree
  std::optional<mesh::TriangleTree> tree_P;  ///< only without planes
  Underside underside_P;                     ///< of a part with a tree
  double reach = 0.0;                        ///< m, of its vertices from the origin of P
  Clear clear;                               ///< of a part with a tree
};

/// `cell`: m, of the index of the rock that it meets.
RubbingPart prepare_rubbing_part(const bit::Part& part, int index, double cell);

/// Buffers, kept between calls so that none allocates once warm.
struct RubbingWork {
  BoxSidesWork around;
  std::vector<int> near;     ///< vertices around the part, in the order of their numbers
  std::vector<Vec3> near_P;  ///< m
  std::vector<std::uint8_t>
      beyond;                 ///< per near vertex: beyond which sides of the part's box, as bits
  std::vector<double> depth;  ///< m, of near vertices inside the part, positive; outside: negative
  std::vector<int> slot;      ///< per vertex of the rock: its place in `near`, or -1
  std::vector<Vec3> polygon, clipped;
  std::vector<ContactPatch> patches;  ///< of the last call
};

/// The rock surface inside a closed part at the pose X_WP (ours): triangles are clipped to the part,
/// exactly by the planes of a convex one. For any other part the crossings of its surface with the
/// edges are interpolated linearly between the vertices' signed distances, and triangles without a
/// vertex inside do not count. Triangles are found if one of their vertices is within `edge` (m), the
/// length of the rock's longest edges, of the part's box. The sums do not depend on the index. `cut` is
/// the last cut of the rock; the index of the rock shows whether anything else changed it since the
/// last call.
/// `work.patches` has the same contact by sectors about the part's z axis, if it is not convex: the
/// velocity of a bit body that touches all around differs from sector to sector.
ContactPatch rubbing_contact(const Rock& rock, RubbingPart& part, const Pose& X_WP, double edge,
                             const CutWorkspace& cut, RubbingWork& work);

/// The greatest distance (m) of a rock vertex inside a closed part from the part's surface; 0: no
/// vertex is inside.
double depth_in_rock(const mesh::Surface& surface, const bit::Part& part, const Pose& X_WP);

}  // namespace tdbd::rock
