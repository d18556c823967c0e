#pragma once

#include <array>
#include <optional>

#include "rock/section/column_sums.hpp"

namespace tdbd::rock {

/// The sides of a face, seen from the rock ahead: left is towards -Y of frame F.
enum class FaceSide { left, right };

/// Heights (z in F, m) of the highest points of the outline's lower edge that lie in rock, by
/// FaceSide; none: that side is in the open. Where the engaged edge has gaps, the highest piece
/// counts.
using EngagedEnds = std::array<std::optional<double>, 2>;

/// Of the columns whose sums these are. Each piece of the edge is taken to be engaged without a
/// gap. Rock above the outline's widest point does not count.
EngagedEnds engaged_ends(const FaceColumns& face, const ColumnSums& sums);

}  // namespace tdbd::rock
