#include "core/observed_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tdbd {
namespace {

double local_order(std::span<const double> steps, std::span<const double> errors, std::size_t i) {
  return std::log(errors[i] / errors[i + 1]) / std::log(steps[i] / steps[i + 1]);
}

/// Contiguous errors [first, last) above the floor, ending at the finest such error.
struct Run {
  std::size_t first = 0, last = 0;
  std::size_t size() const { return last - first; }
};

Run run_above(std::span<const double> errors, const std::vector<double>& floors) {
  Run r{errors.size(), errors.size()};
  while (r.last > 0 && errors[r.last - 1] <= floors[r.last - 1]) --r.last;
  r.first = r.last;
  while (r.first > 0 && errors[r.first - 1] > floors[r.first - 1]) --r.first;
  return r;
}

/// For every error, the level below which rounding may dominate.
std::vector<double> floors_of(std::size_t size, double scale, std::span<const long> counts) {
  std::vector<double> floors(size, scale * order_floor);
  for (std::size_t i = 0; i < counts.size(); ++i)
    floors[i] =
        std::max(floors[i], scale * order_rounding_per_step * static_cast<double>(counts[i]));
  return floors;
}

/// The part of a run in which the local orders are close to the finest one.
Run asymptotic_part(std::span<const double> steps, std::span<const double> errors, Run run) {
  if (run.size() < 2) return run;
  const double finest = local_order(steps, errors, run.last - 2);
  std::size_t first = run.last - 2;
  while (first > run.first && std::abs(local_order(steps, errors, first - 1) - finest) <=
                                  order_scatter_limit * std::abs(finest))
    --first;
  return {first, run.last};
}

std::vector<double> local_orders(std::span<const double> steps, std::span<const double> errors,
                                 const std::vector<double>& floors) {
  std::vector<double> orders;
  for (std::size_t i = 0; i + 1 < errors.size(); ++i)
    orders.push_back(errors[i] > floors[i] && errors[i + 1] > floors[i + 1]
                         ? local_order(steps, errors, i)
                         : std::numeric_limits<double>::quiet_NaN());
  return orders;
}

}  // namespace

double least_squares_order(std::span<const double> steps, std::span<const double> errors) {
  const auto n = static_cast<double>(errors.size());
  double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    mean_x += std::log(steps[i]) / n;
    mean_y += std::log(errors[i]) / n;
  }
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double x = std::log(steps[i]) - mean_x;
    xx += x * x;
    xy += x * (std::log(errors[i]) - mean_y);
  }
  return xy / xx;
}

ObservedOrder observed_order(std::span<const double> steps, std::span<const double> errors,
                             double scale, std::span<const long> counts) {
  const std::vector<double> floors = floors_of(errors.size(), scale, counts);
  ObservedOrder o;
  o.local_orders = local_orders(steps, errors, floors);
  const auto is_rounding = [](double e, double floor) { return e <= order_exact * floor; };
  if (!errors.empty() && std::equal(errors.begin(), errors.end(), floors.begin(), is_rounding)) {
    o.verdict = OrderVerdict::exact;
    return o;
  }
  const Run above = run_above(errors, floors);
  o.above_floor = static_cast<int>(above.size());
  if (above.size() >= 2)
    o.order_of_all = least_squares_order(steps.subspan(above.first, above.size()),
                                         errors.subspan(above.first, above.size()));
  const Run range = asymptotic_part(steps, errors, above);
  o.first = static_cast<int>(range.first);
  o.used = static_cast<int>(range.size());
  if (o.above_floor < order_least_errors) return o;
  o.verdict = o.used < order_least_errors ? OrderVerdict::not_settled : OrderVerdict::order;
  if (o.verdict == OrderVerdict::order)
    o.order = least_squares_order(steps.subspan(range.first, range.size()),
                                  errors.subspan(range.first, range.size()));
  return o;
}

std::string in_words(const ObservedOrder& o, const std::string& what) {
  const std::size_t all = o.local_orders.size() + 1;
  switch (o.verdict) {
    case OrderVerdict::order:
      return fmt::format("{:.3f} ({} of {} {})", o.order, o.used, all, what);
    case OrderVerdict::exact:
      return fmt::format("exact: all {} are rounding", what);
    case OrderVerdict::too_few:
      return fmt::format("no order: {} of {} {} above rounding, at least {} are needed",
                         o.above_floor, all, what, order_least_errors);
    case OrderVerdict::not_settled:
      break;
  }
  return fmt::format("no order: not settled, the slope of all {} is {:.2f}", what, o.order_of_all);
}

}  // namespace tdbd
