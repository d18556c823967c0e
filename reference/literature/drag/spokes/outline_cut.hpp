#pragma once

#include "reference/literature/surface/outline_spokes.hpp"

namespace tdbd::reference {

/// Subtracts a convex outline (positive area) from a piece of rock in the common case: its border
/// enters the outline once and leaves it once, and no cavity is near. Then the border follows the
/// outline in between. In any other case, which planar_boolean must handle, returns false and does
/// nothing. Points are on the grid of planar_boolean, and the border has positive area. A crossing
/// counts only two grid lengths inside the outline, so that grazing contacts are not crossings.
bool cut_between_two_crossings(PlanarFace& rock, const Outline& tool);

/// Subtracts the outline from a spoke's rock: in the common case as above, otherwise by cut_spoke.
/// Nodes are redistributed.
void cut_convex(OutlineSpokes& rock, int spoke, const Outline& tool);

}  // namespace tdbd::reference
