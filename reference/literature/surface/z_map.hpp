#pragma once

#include <vector>

#include "core/pose.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Rock as a height field, the usual rival of a surface mesh: one height for each square cell of
/// the x-y plane. Rock fills z > height (z points down), so no wall can be steeper than a cell
/// allows.
struct ZMap {
  double half = 0.0;           ///< the map covers [-half, half]^2, m
  int cells = 0;               ///< along each side
  std::vector<double> height;  ///< m, at the cells' centres; [row * cells + column], x along a row

  double cell() const { return 2.0 * half / cells; }
  /// Where column or row i has its centre, m.
  double centre(int i) const { return (i + 0.5) * cell() - half; }
};

/// Flat rock at height z.
ZMap flat_z_map(double half, double z, int cells);

/// The part (closed, its frame P) at a pose takes all rock above its lowest point from each cell
/// whose centre it covers. X_WP: part in space. For sweeps call it at many poses.
/// Returns the removed volume, m3. Cost: triangles x cells that they cover.
double cut(ZMap& rock, const mesh::TriangleMesh& part_P, const Pose& X_WP);

}  // namespace tdbd::reference
