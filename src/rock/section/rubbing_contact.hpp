#pragma once

#include <optional>
#include <vector>

#include "bit/bit.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "mesh/shape/convex.hpp"
#include "rock/rock.hpp"
#include "rock/section/contact_area.hpp"

namespace tdbd::rock {

/// A part that rubs: rock may be inside it, since it moves none. Prepared once, by its planes if it is
/// convex, otherwise by a tree over its facets.
struct RubbingPart {
  int part = -1;  ///< index into Bit::parts
  mesh::Box box_P;
  mesh::ConvexSolid solid_P;                 ///< no planes if there is a tree
  std::optional<mesh::TriangleTree> tree_P;  ///< only without planes
};

RubbingPart prepare_rubbing_part(const bit::Part& part, int index);

/// Buffers, kept between calls so that none allocates once warm.
struct RubbingWork {
  std::vector<int> chains;
  std::vector<int> near;      ///< vertices around the part, in the order of their numbers
  std::vector<Vec3> near_P;   ///< m
  std::vector<double> depth;  ///< m, of near vertices inside the part, positive; outside: negative
  std::vector<int> slot;      ///< per vertex of the rock: its place in `near`, or -1
  std::vector<Vec3> polygon, clipped;
};

/// The rock surface inside a closed part at the pose X_WP (ours): triangles are clipped to the part,
/// exactly by the planes of a convex one. For any other part the crossings of its surface with the
/// edges are interpolated linearly between the vertices' signed distances, and triangles without a
/// vertex inside do not count. Triangles are found if one of their vertices is within `edge` (m), the
/// length of the rock's longest edges, of the part's box. The sums do not depend on the index.
ContactPatch rubbing_contact(const Rock& rock, const RubbingPart& part, const Pose& X_WP,
                             double edge, RubbingWork& work);

/// The greatest distance (m) of a rock vertex inside a closed part from the part's surface; 0: no
/// vertex is inside.
double depth_in_rock(const mesh::Surface& surface, const bit::Part& part, const Pose& X_WP);

}  // namespace tdbd::rock
