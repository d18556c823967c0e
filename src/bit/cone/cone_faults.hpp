#pragma once

#include <string>
#include <vector>

#include "bit/cone.hpp"

namespace tdbd::bit {

/// One reason why a cone cannot be made: which value, what it is, what it should be.
struct ConeFault {
  int row = -1;  ///< index into ConeLayout::rows; -1: a fault of the cone itself
  std::string key;
  std::string found;
  std::string expected;
};

/// The faults of a drawn cone; empty if there are none. A profile that folds (s does not rise) or
/// meets the axis between its ends; a row off the shell; angles that do not rise within one turn;
/// teeth of impossible proportions (tooth_faults); a tip inside the cone; a tooth's base that
/// stands off it; teeth of one cone that collide. Two teeth collide when no face plane of either
/// separates them; of every two rows the first such pair is reported, as a fault of the later row.
std::vector<ConeFault> cone_faults(const ConeLayout& cone);

/// Proportions from which tooth_mesh makes no convex tooth: lengths that are not positive, a crest
/// wider than its base, a hemisphere that ends below its shank, a tip larger than its insert.
std::vector<ConeFault> tooth_faults(const ToothShape& shape);

}  // namespace tdbd::bit
