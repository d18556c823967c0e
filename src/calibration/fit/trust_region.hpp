#pragma once

#include <Eigen/Dense>
#include <vector>

#include "calibration/fit/problem.hpp"
#include "core/config/field.hpp"

namespace tdbd::calibration {

/// Maps a free variable u to a coefficient within its range, so that an unbounded search stays
/// inside, calibration (4): logistic between two ends, exponential above one end, identity without
/// ends.
double value_of(const Range& range, double u);
double free_variable(const Range& range, double value);

/// dvalue/du.
double slope_at(const Range& range, double value);

/// Whether a value is at an end of its range as far as the map permits: within this share of the
/// range, or for a single end, of its distance from the start.
inline constexpr double at_bound_share = 1e-4;
bool is_at_bound(const Range& range, double value, double start);

inline constexpr int most_iterations = 200;

/// A search with the trust region method of GSL (double dogleg, singular value decomposition). It
/// changes the unknowns `free` by their free variables (trust_region.hpp) and keeps the others
/// fixed. Uses one-sided differences; converges to a gradient of 1e-5, far below a standard error.
struct Search {
  const Problem& problem;
  const Data& data;
  Eigen::VectorXd values;
  std::vector<Eigen::Index> free;
  long evaluations = 0;

  const Unknown& unknown(std::size_t i) const {
    return problem.unknowns[static_cast<std::size_t>(free[i])];
  }
};

/// Runs the search and changes the values. Returns the status of GSL, or GSL_CONTINUE if an unknown
/// was driven to an end of its range, where its unbounded free variable would use the whole trust
/// region.
int search_from_values(Search& search);

/// Whether a value is at an end of its range and the objective decreases beyond it, according to
/// the sign of the gradient.
bool is_driven_out_of_range(const Unknown& unknown, double value, double gradient);

/// Fixed value of a coefficient that is driven out: a billionth of the range inside its end.
double end_of(const Unknown& unknown, double value);

/// Width of the part of an unknown's range that counts as its end.
double end_width(const Unknown& unknown);

/// Starting value of an unknown that is freed again: ten times that width inside.
double inside_of(const Unknown& unknown, double value);

/// Refines the result of a search to ten digits by Gauss-Newton steps over the free unknowns. The
/// search minimizes the sum of squares and cannot resolve values closer than the square root of
/// rounding, so the order of records would affect the eighth digit. If a step is not small, the
/// readings do not determine the direction, and the refinement stops.
void polish(Search& search);

}  // namespace tdbd::calibration
