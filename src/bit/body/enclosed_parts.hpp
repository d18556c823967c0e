#pragma once

#include <utility>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Returns pairs (inner, outer) of indices into Bit::parts. Both parts have a density, and every
/// vertex of the inner part lies inside the outer part's mesh, so its volume counts twice in the
/// mass. Sorted by the inner part, then the outer part.
std::vector<std::pair<int, int>> enclosed_parts(const Bit& bit);

}  // namespace tdbd::bit
