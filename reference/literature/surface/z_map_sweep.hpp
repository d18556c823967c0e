#pragma once

#include "reference/literature/surface/sweep_tool.hpp"
#include "reference/literature/surface/z_map.hpp"

namespace tdbd::reference {

/// The cut of z_map in the manner of fast height-field programs: facet by facet and row by row,
/// with all cells of a row at once and depths incremented along the row. Lowers every cell whose
/// centre a facet covers to the facet's depth there. `lower_B` as in SweepTool, X_WB its frame in
/// space. Corners without a facet are ignored. Returns the removed volume, m3. Equal to `cut` with
/// the same facets up to rounding. The run time is proportional to the number of cells under the
/// facets.
double cut_sweep(ZMap& rock, const mesh::TriangleMesh& lower_B, const Pose& X_WB);

/// One step of all tools. X_WB: the bit at the step's end. Returns the removed volume, m3.
double cut_sweep(ZMap& rock, const std::vector<SweepTool>& tools, const Pose& X_WB);

/// The height field of a rock surface: the deepest of its points at each cell's centre, or its
/// smallest z where it has none. m.
ZMap z_map_of(const mesh::TriangleMesh& rock_W, double half, int cells);

/// Height at a point of the map, bilinear between the centres of the four cells around it, m.
double height_at(const ZMap& rock, double x, double y);

}  // namespace tdbd::reference
