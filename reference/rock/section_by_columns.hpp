#pragma once

#include <vector>

#include "core/types.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Area and first moment of the part of an outline that lies in rock.
struct ColumnSection {
  double area = 0.0;                                 ///< m2
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();  ///< m3
};

/// Slow twin of rock::section for one position of the face. The outline (a convex polygon in the
/// plane X = 0 of its frame F, coordinates Y, Z) is divided into columns along Z of equal width.
/// The line in the middle of each column is intersected with every triangle of the rock. The part
/// of the line between a crossing into the rock and the next one out of it counts. A line that
/// meets an edge or a corner of triangles meets exactly one of them. The error is of order 2 in the
/// width if the rock's outline is smooth, and of order 1 if it is discontinuous. The run time is
/// proportional to columns x triangles.
ColumnSection section_by_columns(const mesh::TriangleMesh& rock_W, const Pose& X_WF,
                                 const std::vector<Eigen::Vector2d>& outline_F, int columns);

}  // namespace tdbd::reference
