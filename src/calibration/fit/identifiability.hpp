#pragma once

#include <string>
#include <vector>

#include "calibration/fit/problem.hpp"

namespace tdbd::calibration {

/// How well readings alone, without priors, see the unknowns: singular values of the whitened
/// derivatives with respect to relative changes of the unknowns, calibration (5).
struct Identifiability {
  std::vector<double> singular_values;    ///< falling: deviations of noise per unit change
  std::vector<double> weakest_direction;  ///< unit, relative changes of the unknowns, seen least
};

Identifiability identifiability_at(const Problem& problem, const Eigen::VectorXd& values);

/// The weakest direction in words: "A2 up 100 % with A4 down 62 % moves the readings by 0.3 of
/// their noise".
std::string in_words(const Problem& problem, const Identifiability& found);

/// Refuses, before anything is fitted, unknowns that act on no part of the bits, and a direction
/// that neither readings nor priors see: below this share of the largest singular value. Throws
/// InputError with what would help.
inline constexpr double unseen = 1e-7;
void require_identifiable(const Problem& problem);

}  // namespace tdbd::calibration
