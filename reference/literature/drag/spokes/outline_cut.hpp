#pragma once

#include "reference/literature/surface/outline_spokes.hpp"

namespace tdbd::reference {

/// Takes a convex outline (positive area) out of a piece of rock in the common case: its border enters the outline
/// once and leaves it once, and no cavity is near. Then the border follows the outline in between. False, and nothing
/// is done, in any other case, which planar_boolean must settle. Points are on its grid; the border goes round with
/// positive area; an outline counts from two grid lengths inside, so that grazing touches are no crossings.
bool cut_between_two_crossings(PlanarFace& rock, const Outline& tool);

/// Takes the outline out of a spoke's rock: in the common case as above, otherwise by cut_spoke. Nodes are respaced.
void cut_convex(OutlineSpokes& rock, int spoke, const Outline& tool);

}  // namespace tdbd::reference
