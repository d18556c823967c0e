#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// One reason why a cone cannot be made: the key, its value, and what is expected.
struct ConeFault {
  int row = -1;  ///< index into ConeLayout::rows; -1: a fault of the cone itself
  std::string key;
  std::string found;
  std::string expected;
};

/// Returns the faults of a cone's layout: a profile that folds (s does not increase) or meets the
/// axis between its ends; a row off the shell; angles that are not ascending within one turn; teeth
/// of impossible proportions (tooth_faults); a tip inside the cone; the base of a tooth outside the
/// cone; teeth of one cone that collide. Two teeth collide if no face plane of either separates
/// them. Of every two rows, the first such pair is reported as a fault of the later row.
std::vector<ConeFault> cone_faults(const ConeLayout& cone);

/// Returns proportions from which tooth_mesh cannot make a convex tooth: lengths that are not
/// positive, a crest wider than its base, a hemisphere that ends below its shank, a tip larger than
/// its insert.
std::vector<ConeFault> tooth_faults(const ToothShape& shape);

}  // namespace tdbd::bit
