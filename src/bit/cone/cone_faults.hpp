#pragma once

#include <string>
#include <vector>

#include "bit/cone.hpp"

namespace tdbd::bit {

/// One thing that keeps a cone from being made: which value, what it is, what it should be.
struct ConeFault {
  int row = -1;  ///< index into ConeLayout::rows; -1: the cone's own
  std::string key;
  std::string found;
  std::string expected;
};

/// Of a drawn cone: a profile that folds (s does not rise) or meets the axis on its way, a row off
/// the shell, angles that do not rise within one turn, teeth of impossible proportions, a tip that
/// lies inside the cone, a base that stands off it, teeth of one cone that collide (told by a plane
/// of one of them that separates the two; without one they count as colliding). Empty without any.
std::vector<ConeFault> cone_faults(const ConeLayout& cone);

}  // namespace tdbd::bit
