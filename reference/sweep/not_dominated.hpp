#pragma once

#include <vector>

namespace tdbd::reference {

/// Pareto's front by its definition: every row is held against every other one. `larger[k]`: goal k
/// should be large. A row with a value that is not finite is on no front and dominates nothing.
std::vector<char> not_dominated(const std::vector<std::vector<double>>& rows,
                                const std::vector<char>& larger);

}  // namespace tdbd::reference
