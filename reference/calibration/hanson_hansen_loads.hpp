#pragma once

#include <Eigen/Dense>
#include <vector>

#include "forces/part/part_cut.hpp"

namespace tdbd::reference {

/// Coefficients of the law of Hanson and Hansen for faces and chamfers.
struct Coefficients {
  double A1 = 0.0, A2 = 0.0, A3 = 0.0, A4 = 0.0, te = 0.0, A5 = 0.0, A6 = 0.0, pressure_share = 1.0;
};

/// The factors on which the loads depend linearly: A1, A1 A2, A4, A5, A5 A6.
inline constexpr int factors = 5;
using Factors = Eigen::Matrix<double, factors, 1>;
using UnitLoads = Eigen::Matrix<double, 2, factors>;  ///< rows: weight (N), torque (N m)

Factors factors_of(const Coefficients& c);
Coefficients with_factors(Coefficients c, const Factors& x);

/// Loads on a tool for factors of 1, by the formulas, part by part: weight against z, torque
/// against the rotation about z. Of the coefficients only A3, te and pressure_share are used. Parts
/// must drill: they move more along the rock than into it.
UnitLoads unit_loads(const std::vector<forces::PartCut>& cuts, const Coefficients& c);

/// Weight and torque.
Eigen::Vector2d loads(const std::vector<forces::PartCut>& cuts, const Coefficients& c);

/// Slow twin of mean cuts: evaluates the law for the cuts of every step and averages the loads.
Eigen::Vector2d mean_over_steps(const std::vector<std::vector<forces::PartCut>>& steps,
                                const Coefficients& c);

/// d log load / d log depth if the areas of faces grow with the depth and all else is constant.
Eigen::Vector2d depth_slopes(const std::vector<forces::PartCut>& cuts, const Coefficients& c);

}  // namespace tdbd::reference
