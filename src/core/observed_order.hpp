#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace tdbd {

/// What a row of errors over falling steps says.
enum class OrderVerdict {
  order,        ///< the errors fall with the order given
  exact,        ///< every error is at rounding
  too_few,      ///< fewer than three errors above the floor
  not_settled,  ///< the local orders have not settled: no asymptotic range of three errors
};

/// Order of convergence, observed by least squares of log error over log step.
struct ObservedOrder {
  OrderVerdict verdict = OrderVerdict::too_few;
  double order = 0.0;                ///< slope over the range used; 0 unless the verdict is `order`
  double order_of_all = 0.0;         ///< slope over all errors above the floor; 0 below two of them
  std::vector<double> local_orders;  ///< between neighbours; NaN where one is below the floor
  int first = 0;                     ///< place of the first error used
  int used = 0;                      ///< how many errors the slope rests on
  int above_floor = 0;               ///< how many errors lie above the floor
};

/// Errors at or below this are left out; scale: the variable's. The rounding of some hundred steps
/// (1e-13) is a hundredth of it, which turns a slope by less than 0.01.
inline constexpr double order_floor = 1e-11;

/// In long runs the floor rises: so many units of rounding a time step (the slow top's attitude
/// loses a quarter of one); scale: the variable's.
inline constexpr double order_rounding_per_step = 8.0 * std::numeric_limits<double>::epsilon();

/// Errors at or below this part of the floor are rounding, of a variable that is exact.
inline constexpr double order_exact = 0.1;

/// The asymptotic range is the longest run of errors that ends at the finest one above the floor
/// and whose local orders differ from the finest one's by at most this; scale: that order.
inline constexpr double order_settled = 0.05;

/// An order rests on at least so many errors.
inline constexpr int order_least_errors = 3;

/// `steps` falling and positive, as many as `errors`, which are not negative; `scale` is the size
/// of the variable. `counts`: how many time steps each error comes of; empty: few.
ObservedOrder observed_order(std::span<const double> steps, std::span<const double> errors,
                             double scale, std::span<const long> counts = {});

/// Slope of the least-squares line through log error over log step: the order. Needs two or more
/// errors, all positive.
double least_squares_order(std::span<const double> steps, std::span<const double> errors);

/// The verdict in words, with the numbers: "2.001 (5 of 6 differences)". `what` names the errors.
std::string in_words(const ObservedOrder& o, const std::string& what);

}  // namespace tdbd
