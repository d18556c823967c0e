#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace tdbd {

/// Result of a convergence test with decreasing steps.
enum class OrderVerdict {
  order,        ///< the errors decrease with the given order
  exact,        ///< every error is at rounding level
  too_few,      ///< fewer than three errors above the floor
  not_settled,  ///< the local orders vary: no asymptotic range of three errors
};

/// Observed order of convergence: a least-squares fit of log error over log step.
struct ObservedOrder {
  OrderVerdict verdict = OrderVerdict::too_few;
  double order = 0.0;                ///< slope over the range used; 0 unless the verdict is `order`
  double order_of_all = 0.0;         ///< slope over all errors above the floor; 0 if fewer than 2
  std::vector<double> local_orders;  ///< between neighbours; NaN where one is below the floor
  int first = 0;                     ///< index of the first error used
  int used = 0;                      ///< number of errors in the fit
  int above_floor = 0;               ///< number of errors above the floor
};

/// Errors at or below this are ignored. Relative to the scale of the variable. The rounding of a
/// hundred steps (1e-13) is a hundredth of it and changes a slope by less than 0.01.
inline constexpr double order_floor = 1e-11;

/// Increase of the floor per time step, for long runs. Relative to the scale of the variable. The
/// attitude of the slow top loses a quarter of a unit of rounding per step.
inline constexpr double order_rounding_per_step = 8.0 * std::numeric_limits<double>::epsilon();

/// If all errors are at or below this fraction of the floor, they are rounding and the variable is
/// exact.
inline constexpr double order_exact = 0.1;

/// The asymptotic range is the longest run of errors that ends at the finest error above the floor
/// and in which the local orders differ from the finest order by at most this fraction of it.
inline constexpr double order_scatter_limit = 0.05;

/// Smallest number of errors that determines an order.
inline constexpr int order_least_errors = 3;

/// Computes the observed order. `steps` are positive and decreasing; `errors` are non-negative, one
/// per step. `scale` is the magnitude of the variable. `counts` is the number of time steps behind
/// each error; if empty, their rounding is neglected.
ObservedOrder observed_order(std::span<const double> steps, std::span<const double> errors,
                             double scale, std::span<const long> counts = {});

/// Slope of the least-squares line through log error over log step. Requires at least two errors,
/// all positive.
double least_squares_order(std::span<const double> steps, std::span<const double> errors);

/// The verdict as text with its numbers: "2.001 (5 of 6 differences)". `what` is the name of the
/// errors.
std::string in_words(const ObservedOrder& o, const std::string& what);

}  // namespace tdbd
