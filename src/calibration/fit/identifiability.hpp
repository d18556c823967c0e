#pragma once

#include <string>
#include <vector>

#include "calibration/fit/problem.hpp"

namespace tdbd::calibration {

/// Sensitivity of the readings alone, without priors, to the unknowns: singular values of the
/// whitened derivatives with respect to relative changes of the unknowns, calibration (5).
struct Identifiability {
  std::vector<double> singular_values;    ///< decreasing: noise deviations per unit change
  std::vector<double> weakest_direction;  ///< unit vector, relative changes, smallest effect
};

Identifiability identifiability_at(const Problem& problem, const Eigen::VectorXd& values);

/// The weakest direction as text: "A2 +100 %, A4 -62 %: this changes the readings by 0.3 of their
/// noise".
std::string in_words(const Problem& problem, const Identifiability& found);

/// Checks a problem before it is fitted. Throws InputError with advice if an unknown affects no
/// part of the bits, or if a direction affects neither readings nor priors: its singular value is
/// below this share of the largest.
inline constexpr double unseen = 1e-7;
void require_identifiable(const Problem& problem);

}  // namespace tdbd::calibration
