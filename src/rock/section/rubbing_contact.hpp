#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "bit/bit.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "mesh/shape/convex.hpp"
#include "rock/cut/cut_rock.hpp"
#include "rock/rock.hpp"
#include "rock/section/contact_area.hpp"
#include "rock/section/underside.hpp"

namespace tdbd::rock {

/// A part that rubs. It moves no rock, so rock may be inside it. Prepared once: by its planes if it
/// is convex, otherwise by a tree over its facets.
struct RubbingPart {
  /// Records that all rock vertices are farther than underside_P.margin from the part at X_WP,
  /// rotated by any angle about its axis.
  struct Clear {
    long changes = -1;  ///< number of the rock index's changes included; -1: not known to be clear
    Pose X_WP;
  };
  int part = -1;  ///< index into Bit::parts
  mesh::Box box_P;
  mesh::ConvexSolid solid_P;                 ///< without planes if there is a tree
  std::optional<mesh::TriangleTree> tree_P;  ///< only if there are no planes
  Underside underside_P;                     ///< of a part with a tree
  double reach = 0.0;                        ///< m, of its vertices from P's origin
  Clear clear;                               ///< of a part with a tree
};

/// `cell`: cell size of the rock's index, m.
RubbingPart prepare_rubbing_part(const bit::Part& part, int index, double cell);

/// Buffers, kept between calls to avoid allocations.
struct RubbingWork {
  BoxSidesWork around;
  std::vector<int> near;     ///< vertices around the part, in ascending order
  std::vector<Vec3> near_P;  ///< m
  std::vector<std::uint8_t>
      beyond;                 ///< per near vertex: the sides of the box beyond which it is, as bits
  std::vector<double> depth;  ///< m, of near vertices; positive inside the part
  std::vector<int> slot;      ///< per vertex of the rock: its index in `near`, or -1
  std::vector<Vec3> polygon, clipped;
  std::vector<ContactPatch> patches;  ///< result of the last call
};

/// Computes the rock surface inside a closed part at the pose X_WP [+]. Triangles are clipped to
/// the part; for a convex part this is exact. For any other part, the crossings of its surface with
/// edges are interpolated linearly between the signed distances of the vertices, and triangles
/// without a vertex inside do not count. A triangle is found if one of its vertices is within
/// `edge` (m), the length of the rock's longest edges, of the part's box. The sums do not depend on
/// the index. `cut`: the last cut of the rock. The rock's index shows whether anything else has
/// changed the rock since the last call. If the part is not convex, `work.patches` contains the
/// same contact divided into sectors about the part's z axis, because the velocity of a bit body
/// that touches all around differs between sectors.
ContactPatch rubbing_contact(const Rock& rock, RubbingPart& part, const Pose& X_WP, double edge,
                             const CutWorkspace& cut, RubbingWork& work);

/// The largest distance (m) from the part's surface of a rock vertex inside a closed part; 0 if no
/// vertex is inside.
double depth_in_rock(const mesh::Surface& surface, const bit::Part& part, const Pose& X_WP);

}  // namespace tdbd::rock
