#pragma once

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

/// Errors at or below this are rounding; scale: the variable's.
inline constexpr double order_exact = 1e-12;

/// Errors at or below this are left out, since rounding of up to order_exact would turn the slope
/// by more than a hundredth; scale: the variable's.
inline constexpr double order_floor = 1e-10;

/// The asymptotic range is the longest run of errors that ends at the finest one above the floor
/// and whose local orders differ from the finest one's by at most this; scale: that order.
inline constexpr double order_settled = 0.05;

/// An order rests on at least so many errors.
inline constexpr int order_least_errors = 3;

/// `steps` falling and positive, as many as `errors`, which are not negative; `scale` is the size
/// of the variable.
ObservedOrder observed_order(std::span<const double> steps, std::span<const double> errors,
                             double scale);

/// Slope of the least-squares line through log error over log step: the order. Needs two or more
/// errors, all positive.
double least_squares_order(std::span<const double> steps, std::span<const double> errors);

/// The verdict in words, with the numbers: "2.001 (5 of 6 differences)". `what` names the errors.
std::string in_words(const ObservedOrder& o, const std::string& what);

}  // namespace tdbd
