#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "verification/battery/golden.hpp"
#include "verification/battery/rotation_scheme.hpp"

namespace tdbd::battery {

/// What the battery measures of a rotation scheme. The limits are in the tests.

/// The state variables of an order table.
inline constexpr std::array<const char*, 5> state_variables = {
    "attitude", "body momentum", "space momentum", "cone angles", "cone momenta"};
/// One number for each: |R - R'|_F / sqrt 2, then largest differences (N m s, rad).
using StateErrors = std::array<double, state_variables.size()>;

/// The golden state at this time. Throws RunError when there is none.
const GoldenState& golden_at(const GoldenCase& c, double time);

/// A golden state in the program's unknowns.
dynamics::RotationState as_state(const GoldenState& golden);

/// The same state in another scalar.
template <class S>
dynamics::RotationStateOf<S> as_scalar(const dynamics::RotationState& s) {
  dynamics::RotationStateOf<S> t;
  t.q_WB = s.q_WB.cast<S>();
  t.momentum_W = s.momentum_W.cast<S>();
  t.cone_angles.assign(s.cone_angles.begin(), s.cone_angles.end());
  t.cone_momenta.assign(s.cone_momenta.begin(), s.cone_momenta.end());
  t.turns = s.turns;
  t.time = s.time;
  return t;
}

template <class S>
double largest_difference(const std::vector<S>& a, const std::vector<S>& b) {
  S d(0);
  for (std::size_t i = 0; i < a.size(); ++i) d = std::max(d, std::abs(a[i] - b[i]));
  return static_cast<double>(d);
}

/// Difference of two states, with the rounding of S.
template <class S>
StateErrors state_errors(const dynamics::RotationStateOf<S>& a,
                         const dynamics::RotationStateOf<S>& b) {
  const Eigen::Matrix<S, 3, 3> R_error = a.q_WB.toRotationMatrix() - b.q_WB.toRotationMatrix();
  const dynamics::Vec3Of<S> body = dynamics::body_momentum(a) - dynamics::body_momentum(b);
  const dynamics::Vec3Of<S> space = a.momentum_W - b.momentum_W;
  return {static_cast<double>(R_error.norm()) / std::numbers::sqrt2,
          static_cast<double>(body.cwiseAbs().maxCoeff()),
          static_cast<double>(space.cwiseAbs().maxCoeff()),
          largest_difference(a.cone_angles, b.cone_angles),
          largest_difference(a.cone_momenta, b.cone_momenta)};
}

/// The scheme's state after so many steps of size h from the case's start.
dynamics::Rotating carry(const RotationScheme& scheme, const GoldenCase& c, double h, long steps);

/// Largest error of any variable after so many steps with h and as many with -h.
double reversibility_defect(const RotationScheme& scheme, const GoldenCase& c, double h,
                            long steps);

/// Largest changes over so many steps.
struct ConservationDefects {
  double space_momentum = 0.0;     ///< N m s
  double vertical_momentum = 0.0;  ///< N m s, along space z
  double cone_momenta = 0.0;       ///< N m s
  double unit_quaternion = 0.0;    ///< | |q|^2 - 1 |
};
ConservationDefects conservation_defects(const RotationScheme& scheme, const GoldenCase& c,
                                         double h, long steps);

/// Energy error (E - E0) / |E0| over a long run.
struct EnergyRecord {
  std::array<double, 5> mean_of_fifth{};  ///< of five consecutive fifths
  double largest = 0.0;                   ///< over all steps
  double largest_of_first_hundredth = 0.0;
};
EnergyRecord energy_record(const RotationScheme& scheme, const GoldenCase& c, double h, long steps);

/// Kinetic and potential energy, J.
double total_energy(const GoldenCase& c, const dynamics::RotationState& s);

}  // namespace tdbd::battery
