#pragma once

#include <vector>

#include "core/pose.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Area and first moment of the part of an outline that lies in rock.
struct ColumnSection {
  double area = 0.0;                                 ///< m2
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();  ///< m3
};

/// The slow twin of rock::section for one position of the face. The outline (a convex polygon in
/// the plane X = 0 of its frame F, coordinates Y, Z) is cut into columns along Z of equal width; in
/// the middle of each the line is cut with every triangle of the rock, and what lies below a
/// crossing into the rock and above one out of it counts. A line that meets an edge or a corner of
/// triangles meets one of them. The error falls with order 2 in the width where the rock's outline
/// is smooth, 1 where it jumps. Cost: columns x triangles.
ColumnSection section_by_columns(const mesh::TriangleMesh& rock_W, const Pose& X_WF,
                                 const std::vector<Eigen::Vector2d>& outline_F, int columns);

}  // namespace tdbd::reference
