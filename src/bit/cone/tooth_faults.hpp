#pragma once

#include <vector>

#include "bit/cone/cone_faults.hpp"

namespace tdbd::bit {

/// Proportions from which tooth_mesh makes no convex tooth: lengths that are not positive, a crest
/// wider than its base, a half-ball that ends below its shank, a tip larger than its insert.
std::vector<ConeFault> tooth_faults(const ToothShape& shape);

}  // namespace tdbd::bit
