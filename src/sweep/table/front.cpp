#include "sweep/table/front.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tdbd::sweep {
namespace {

using Row = std::vector<double>;

/// Values that should become small.
Row costs_of(const Row& row, const std::vector<Goal>& goals) {
  Row costs = row;
  for (std::size_t k = 0; k < costs.size(); ++k)
    if (goals[k].sense == Sense::larger) costs[k] = -costs[k];
  return costs;
}

/// As good in every goal, better in one.
bool dominates(const Row& a, const Row& b) {
  bool better = false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] > b[k]) return false;
    better = better || a[k] < b[k];
  }
  return better;
}

}  // namespace

/// In lexicographic order a row can only be dominated by one that came before, and then also by one
/// of the front so far (Kung, Luccio and Preparata 1975).
std::vector<char> front_of(const std::vector<Row>& rows, const std::vector<Goal>& goals) {
  std::vector<char> on_front(rows.size(), 0);
  if (goals.empty()) return on_front;
  std::vector<Row> costs;
  costs.reserve(rows.size());
  for (const Row& row : rows) costs.push_back(costs_of(row, goals));
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < costs.size(); ++i)
    if (std::ranges::all_of(costs[i], [](double x) { return std::isfinite(x); }))
      order.push_back(i);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) -> const Row& { return costs[i]; });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    if (std::ranges::any_of(front, [&](std::size_t j) { return dominates(costs[j], costs[i]); }))
      continue;
    front.push_back(i);
    on_front[i] = 1;
  }
  return on_front;
}

}  // namespace tdbd::sweep
