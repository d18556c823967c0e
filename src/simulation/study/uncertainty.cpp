#include "simulation/study/uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/types.hpp"

namespace tdbd::simulation {
namespace {

/// Safety factors of the grid convergence index: with an observed order, and without.
constexpr double observed_factor = 1.25, cautious_factor = 3.0;

/// Smaller orders are noise rather than convergence. `usual_order` is the largest order assumed if
/// the method states none.
constexpr double least_order = 0.5, usual_order = 2.0;

/// (9): remainder of a geometric series after the difference between level `index` and the next.
double error_after(std::span<const double> sizes, double difference, std::size_t index,
                   double order) {
  return difference / (std::pow(sizes[index] / sizes[index + 1], order) - 1.0);
}

/// Median slope of all pairs (Theil 1950, Sen 1968). In a least-squares fit, one difference that is
/// small by chance would increase the slope and make the estimate too small.
double median_slope(std::span<const double> sizes, std::span<const double> differences) {
  std::vector<double> slopes;
  for (std::size_t i = 0; i < differences.size(); ++i)
    for (std::size_t j = i + 1; j < differences.size(); ++j)
      if (differences[i] > 0.0 && differences[j] > 0.0)
        slopes.push_back(std::log(differences[i] / differences[j]) / std::log(sizes[i] / sizes[j]));
  if (slopes.empty()) return 0.0;
  std::ranges::sort(slopes);
  const std::size_t n = slopes.size();
  return 0.5 * (slopes[(n - 1) / 2] + slopes[n / 2]);
}

/// (11): the largest of scattered differences, each scaled to the finest size along the slope,
/// because the finest difference may be small by chance.
double envelope(std::span<const double> sizes, std::span<const double> differences, double order) {
  const double finest = sizes[differences.size() - 1];
  double largest = 0.0;
  for (std::size_t i = 0; i < differences.size(); ++i)
    largest = std::max(largest, differences[i] * std::pow(finest / sizes[i], order));
  return largest;
}

}  // namespace

Uncertainty uncertainty_of(const ObservedOrder& observed, std::span<const double> sizes,
                           std::span<const double> differences, double nominal, double range) {
  if (observed.verdict == OrderVerdict::exact) return {UncertaintyBasis::exact};
  const double most = nominal > 0.0 ? nominal : usual_order;
  const auto estimate = [&](UncertaintyBasis basis, double order, double factor, double difference,
                            std::size_t index) -> Uncertainty {
    const double error = error_after(sizes, difference, index, order);
    return {basis, order, factor, error, factor * error};
  };
  if (observed.verdict == OrderVerdict::order && observed.order >= least_order) {
    const std::size_t last = at(observed.first + observed.used - 1);
    return estimate(UncertaintyBasis::observed_order, std::min(observed.order, most),
                    observed_factor, differences[last], last);
  }
  const double slope = std::min(median_slope(sizes, differences), most);
  if (observed.above_floor >= 2 && slope >= least_order) {
    return estimate(UncertaintyBasis::slope, slope, cautious_factor,
                    envelope(sizes, differences, slope), differences.size() - 1);
  }
  return {UncertaintyBasis::range, 0.0, cautious_factor, range, cautious_factor * range};
}

const char* name_of(UncertaintyBasis basis) {
  switch (basis) {
    case UncertaintyBasis::exact:
      return "exact";
    case UncertaintyBasis::observed_order:
      return "observed order";
    case UncertaintyBasis::slope:
      return "slope of all differences";
    case UncertaintyBasis::range:
      break;
  }
  return "range of the levels";
}

}  // namespace tdbd::simulation
