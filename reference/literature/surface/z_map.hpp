#pragma once

#include <vector>

#include "core/types.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Rock as a height field, the usual alternative to a surface mesh: one height for each square cell
/// of the x-y plane. Rock fills z > height (z points down), so no wall can be steeper than the cell
/// size allows.
struct ZMap {
  double half = 0.0;           ///< the map covers [-half, half]^2, m
  int cells = 0;               ///< along each side
  std::vector<double> height;  ///< m, at the cells' centres; [row * cells + column], x along a row

  double cell() const { return 2.0 * half / cells; }
  /// Centre of column or row i, m.
  double centre(int i) const { return (i + 0.5) * cell() - half; }
};

/// Flat rock at height z.
ZMap flat_z_map(double half, double z, int cells);

/// Removes the rock above the lowest point of a part (closed, its frame P) from each cell whose
/// centre it covers. X_WP: part in space. For sweeps, call it at many poses. Returns the removed
/// volume, m3. The run time is proportional to the triangles times the cells that they cover.
double cut(ZMap& rock, const mesh::TriangleMesh& part_P, const Pose& X_WP);

}  // namespace tdbd::reference
