#pragma once

#include <vector>

namespace tdbd::reference {

/// The Pareto front by its definition: every row is compared with every other one. `larger[k]`:
/// goal k should be large. A row with a value that is not finite is not on the front and dominates
/// no other row.
std::vector<char> not_dominated(const std::vector<std::vector<double>>& rows,
                                const std::vector<char>& larger);

}  // namespace tdbd::reference
