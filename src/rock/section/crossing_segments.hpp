#pragma once

#include "rock/rock.hpp"
#include "rock/section/column_sums.hpp"
#include "rock/section/crossed_edges.hpp"

namespace tdbd::rock {

/// Columns of a face at the place it is carried to, and how far around them to search for rock.
struct FacePlane {
  Vec3 n_W, y_W, z_W;  ///< axes of F; n into the rock ahead
  double n0, y0, z0;   ///< m, of F's origin along them
  const FaceColumns& face;
  double left, right;  ///< m, y of the ends of the columns
  double reach;        ///< m
  double top;          ///< m, largest z of vertices to start from
  int near_list;       ///< index of the rock's list that may cover the zone; -1: none

  double ahead(const Vec3& x_W) const { return dot(n_W, x_W) - n0; }
  Vec2 in_plane(const Vec3& x_W) const { return {dot(y_W, x_W) - y0, dot(z_W, x_W) - z0}; }

 private:
  /// In plain numbers, of which three cost less than a packet and a half.
  static double dot(const Vec3& n, const Vec3& x) {
    return n.x() * x.x() + n.y() * x.y() + n.z() * x.z();
  }
};

FacePlane face_plane(const Pose& X_WF, const FaceColumns& face, std::size_t first, std::size_t end,
                     double reach, double top, int near_list);

/// Where a point of the outline lies: inside the columns at work, away from their edges; not above
/// the line of the lower edge of a column, the one beside it or nearby; or anywhere else.
enum class PointPlace : std::uint8_t { anywhere, inside, beneath };

struct PlacedPoint {
  PointPlace place;
  const FaceColumn* column;  ///< beside the point; inside: may be null
};

/// Points of the outline from `first` to before `end`, two or more, rock on their left.
struct OutlineRun {
  std::size_t first, end;
};

/// Buffers for the pieces of the rock's outline.
struct OutlineWork {
  std::vector<int> chains;
  std::vector<int> near;     ///< vertices to start from
  std::vector<double> y, z;  ///< m, of the points, in the plane of F
  std::vector<PlacedPoint> place;
  std::vector<OutlineRun> runs;
  CrossedEdges crossed;  ///< by the plane at work, at which a segment begins
};

/// Where the rock's triangles cross the plane of a face, beside some of its columns: work.runs of
/// points. Runs may come in any order and begin anywhere; each triangle gives one segment, between two
/// neighbouring points of a run. Corners in the plane count as ahead. The zone is what lies
/// within `reach` of the columns' ends and lower edges. An outline within the zone is found whole if
/// one of its triangles there has a vertex to start from: in the zone, not above `top`, nor below
/// the face's box by more than `reach`, and ahead of the plane by at most `reach`. From such
/// vertices on the outline is followed from triangle to triangle, however long their edges are.
void find_outline(const Rock& rock, const FacePlane& plane, OutlineWork& work);

/// Whether the segment from point k to the next is beneath the face, so that no part of the face lies
/// below it. Conservative: may return false for a segment that is.
bool is_beneath(const OutlineWork& work, std::size_t k);

}  // namespace tdbd::rock
