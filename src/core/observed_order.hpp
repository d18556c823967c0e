#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace tdbd {

/// What a sequence of errors for decreasing steps shows.
enum class OrderVerdict {
  order,        ///< the errors decrease with the given order
  exact,        ///< every error is rounding
  too_few,      ///< fewer than three errors above the floor
  not_settled,  ///< the local orders have not settled: no asymptotic range of three errors
};

/// Order of convergence, observed by least squares of log error over log step.
struct ObservedOrder {
  OrderVerdict verdict = OrderVerdict::too_few;
  double order = 0.0;                ///< slope over the range used; 0 unless the verdict is `order`
  double order_of_all = 0.0;         ///< slope over all errors above the floor; 0 below two of them
  std::vector<double> local_orders;  ///< between neighbours; NaN where one is below the floor
  int first = 0;                     ///< index of the first error used
  int used = 0;                      ///< how many errors the slope is fitted to
  int above_floor = 0;               ///< how many errors lie above the floor
};

/// Errors at or below this are ignored; scale: that of the variable. The rounding of a hundred steps (1e-13) is a
/// hundredth of it and changes a slope by less than 0.01.
inline constexpr double order_floor = 1e-11;

/// In long runs the floor rises by this per time step (the attitude of the slow top loses a quarter of a unit of
/// rounding per step); scale: that of the variable.
inline constexpr double order_rounding_per_step = 8.0 * std::numeric_limits<double>::epsilon();

/// If all errors are at or below this fraction of the floor, the variable is exact and they are rounding.
inline constexpr double order_exact = 0.1;

/// The asymptotic range is the longest run of errors that ends at the finest one above the floor and whose local orders
/// differ from the finest by at most this fraction of it.
inline constexpr double order_settled = 0.05;

/// An order needs at least this many errors.
inline constexpr int order_least_errors = 3;

/// `steps`: positive and decreasing, as many as `errors`, which are not negative. `scale`: the size of the variable.
/// `counts`: how many time steps each error comes from; empty: few.
ObservedOrder observed_order(std::span<const double> steps, std::span<const double> errors,
                             double scale, std::span<const long> counts = {});

/// The order: the slope of the least-squares line through log error over log step. Needs at least two errors, all
/// positive.
double least_squares_order(std::span<const double> steps, std::span<const double> errors);

/// The verdict in words, with the numbers: "2.001 (5 of 6 differences)". `what` names the errors.
std::string in_words(const ObservedOrder& o, const std::string& what);

}  // namespace tdbd
