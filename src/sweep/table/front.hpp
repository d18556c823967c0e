#pragma once

#include <vector>

#include "sweep/design/design.hpp"

namespace tdbd::sweep {

/// Which rows no other row dominates: one that is as good in every goal and better in one (Pareto's
/// front). `rows`: a value for each goal, in the design's order; a row with a value that is not
/// finite is never on the front. 1: on it.
std::vector<char> front_of(const std::vector<std::vector<double>>& rows,
                           const std::vector<Goal>& goals);

}  // namespace tdbd::sweep
