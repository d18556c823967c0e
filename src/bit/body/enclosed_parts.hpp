#pragma once

#include <utility>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Pairs (inner, outer) of indices into Bit::parts: both have a density, and every vertex of the
/// inner part lies inside the outer part's mesh, so its volume counts twice in the mass. Sorted by
/// the inner part, then the outer one.
std::vector<std::pair<int, int>> enclosed_parts(const Bit& bit);

}  // namespace tdbd::bit
