#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Largest distance (m) of a cutting part's vertex from the bit's axis: the gage radius. 0 if no
/// part cuts. Thesis: 3.1.
double largest_radius(const std::vector<Part>& parts);

}  // namespace tdbd::bit
