#pragma once

#include <vector>

namespace tdbd::bit {

/// Angles (rad, rising, in [0, 2 pi)) of `teeth` teeth from the first one's angle on. The spaces
/// between them stand in the ratios of `pattern`, which is repeated as often as needed and may be
/// cut short; an empty one means equal spaces. All spaces together are one turn.
std::vector<double> spaced_angles(int teeth, double first_angle,
                                  const std::vector<double>& pattern);

}  // namespace tdbd::bit
