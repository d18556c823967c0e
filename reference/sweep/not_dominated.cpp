#include "reference/sweep/not_dominated.hpp"

#include <cmath>

namespace tdbd::reference {
namespace {

bool is_finite(const std::vector<double>& row) {
  for (const double x : row)
    if (!std::isfinite(x)) return false;
  return true;
}

bool dominates(const std::vector<double>& a, const std::vector<double>& b,
               const std::vector<char>& larger) {
  int better = 0, worse = 0;
  for (std::size_t k = 0; k < larger.size(); ++k) {
    if (larger[k] != 0 ? a[k] > b[k] : a[k] < b[k]) ++better;
    if (larger[k] != 0 ? a[k] < b[k] : a[k] > b[k]) ++worse;
  }
  return better > 0 && worse == 0;
}

}  // namespace

std::vector<char> not_dominated(const std::vector<std::vector<double>>& rows,
                                const std::vector<char>& larger) {
  std::vector<char> on_front;
  for (const auto& row : rows) {
    bool dominated = !is_finite(row);
    for (const auto& other : rows)
      dominated = dominated || (is_finite(other) && dominates(other, row, larger));
    on_front.push_back(dominated ? 0 : 1);
  }
  return on_front;
}

}  // namespace tdbd::reference
