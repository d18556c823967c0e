#pragma once

#include <array>
#include <optional>

#include "rock/section/column_sums.hpp"

namespace tdbd::rock {

/// The sides of a face, seen from the rock ahead. Left is towards -Y of frame F.
enum class FaceSide { left, right };

/// Heights (z in F, m), by FaceSide, of the highest points of the outline's lower edge that are in
/// rock. Empty if no point on that side is in rock. If the engaged edge has gaps, its highest piece
/// counts.
using EngagedEnds = std::array<std::optional<double>, 2>;

/// Computes the ends from the sums over a face's columns. Each piece of the edge is assumed to be
/// engaged without a gap. Rock above the outline's widest point does not count.
EngagedEnds engaged_ends(const FaceColumns& face, const ColumnSums& sums);

}  // namespace tdbd::rock
