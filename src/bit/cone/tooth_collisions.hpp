#pragma once

#include <vector>

#include "bit/cone/cone_faults.hpp"

namespace tdbd::bit {

/// Teeth of one cone that no plane of either separates, the first pair of every two rows (or of one
/// row): a fault of the later row. Needs rows without faults of their own.
std::vector<ConeFault> tooth_collisions(const ConeLayout& cone);

}  // namespace tdbd::bit
