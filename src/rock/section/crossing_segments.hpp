#pragma once

#include "rock/rock.hpp"
#include "rock/section/column_sums.hpp"

namespace tdbd::rock {

/// Columns of a face where it is carried to, and how far around them rock is looked for.
struct FacePlane {
  Vec3 n_W, y_W, z_W;  ///< axes of F; n into the rock ahead
  double n0, y0, z0;   ///< m, of F's origin along them
  const FaceColumns& face;
  double left, right;  ///< m, y of the ends of the columns
  double reach;        ///< m
  double top;          ///< m, z up to which vertices to start from are looked for
  int near_list;       ///< of the rock's lists, that which may cover the zone; -1: none

  double ahead(const Vec3& x_W) const { return n_W.dot(x_W) - n0; }
  Vec2 in_plane(const Vec3& x_W) const { return {y_W.dot(x_W) - y0, z_W.dot(x_W) - z0}; }
};

FacePlane face_plane(const Pose& X_WF, const FaceColumns& face, std::size_t first, std::size_t end,
                     double reach, double top, int near_list);

/// Room for the pieces of the rock's outline.
struct OutlineWork {
  std::vector<int> chains;
  std::vector<int> near;  ///< vertices to start from
  std::vector<OutlineSegment> segments;
  std::vector<OutlineSegment> run;
};

/// Where the rock's triangles cross the plane of a face, beside some of its columns: work.segments,
/// in any order, each triangle's once. Corners in the plane count as ahead. The zone is what is at
/// most `reach` from the columns, for all that their ends and their lower edges tell. Of an outline
/// of the rock all that lies within the zone is found, if one of its triangles there has a vertex
/// in the zone, not above `top`, that is ahead of the plane by at most `reach`; from such vertices
/// on the outline is followed from triangle to triangle, however long their edges are.
void find_outline(const Rock& rock, const FacePlane& plane, OutlineWork& work);

}  // namespace tdbd::rock
