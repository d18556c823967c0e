#pragma once

#include <Eigen/Dense>
#include <vector>

#include "calibration/fit/problem.hpp"

namespace tdbd::calibration {

inline constexpr int most_iterations = 200;

/// A search with GSL's trust region (double dogleg, singular value decomposition): it moves the
/// unknowns `free` over their free variables (bounded_map.hpp), the others stay. One-sided
/// differences, to a gradient of 1e-5: far below a standard error.
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

/// Moves the values. Returns GSL's status; GSL_CONTINUE where an unknown was driven to an end of its
/// range, where its free variable has none and takes the whole trust region.
int search_from_values(Search& search);

/// Whether a value is on an end of its range and the objective falls beyond it, by the gradient's
/// sign.
bool is_driven_out(const Unknown& unknown, double value, double gradient);

/// Where a coefficient stays that is driven out: at its end, a billionth of the range inside.
double end_of(const Unknown& unknown, double value);

/// How much of an unknown's range counts as its end.
double end_width(const Unknown& unknown);

/// Where one that is freed again starts: ten times that inside.
double inside_of(const Unknown& unknown, double value);

}  // namespace tdbd::calibration
