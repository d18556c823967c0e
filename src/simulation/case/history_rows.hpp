#pragma once

#include <algorithm>

namespace tdbd::simulation {

/// Rows that a history has at most unless the case says otherwise: what plots and files bear.
inline constexpr long most_history_rows = 10'000;

/// Steps between the rows of so many steps.
inline long usual_history_every(long steps) {
  return std::max(1L, (steps + most_history_rows - 1) / most_history_rows);
}

}  // namespace tdbd::simulation
