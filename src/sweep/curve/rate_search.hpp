#pragma once

#include <cstddef>
#include <span>

namespace tdbd::sweep {

/// A run at a weight and the rate of penetration that it had.
struct RatePoint {
  double weight = 0.0;    ///< N, > 0
  double rate = 0.0;      ///< m/s
  double interval = 0.0;  ///< m/s, half-width of the confidence interval of the rate
};

/// What a search looks for.
struct RateGoal {
  double rate = 0.0;          ///< m/s, > 0
  double tolerance = 0.02;    ///< largest difference of a rate, relative to `rate`
  double first_weight = 0.0;  ///< N, of the first run if there is none yet
};

/// The result of looking at the runs made so far.
enum class SearchStep {
  run,         ///< a run at RateProposal::weight is needed
  found,       ///< RateProposal::point has the rate
  falls,       ///< the rate falls between RateProposal::point and the next one
  unresolved,  ///< the rate is between two weights that are as good as equal
};

struct RateProposal {
  SearchStep step = SearchStep::run;
  double weight = 0.0;    ///< N, for run
  std::size_t point = 0;  ///< for the others
};

/// Looks for the weight that gives a rate, assuming that the rate grows with the weight, sweep (2).
/// `points`: runs in ascending order of weight. Within their range, the next weight is interpolated
/// linearly in the interval that contains the rate, at least a tenth of it from either end. Outside
/// it is extrapolated, to between 0.4 times the smallest and 2.5 times the largest weight. Weights
/// are rounded to four digits.
RateProposal next_weight(std::span<const RatePoint> points, const RateGoal& goal);

/// The point whose rate is nearest to that of the goal. Requires at least one point.
std::size_t nearest_rate(std::span<const RatePoint> points, double rate);

/// Whether the rate of the goal is within the range of rates of the points.
bool is_within_reach(std::span<const RatePoint> points, double rate);

/// Rounds a positive number to four significant digits.
double four_digits(double x);

}  // namespace tdbd::sweep
