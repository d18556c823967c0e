#pragma once

#include "verification/battery/rotation_scheme.hpp"

namespace tdbd::battery {

/// Canonical coordinates of a gyrostat near an attitude R0: the rotation vector theta of
/// R = R0 exp(theta) and the cones' angles; their momenta dexp_theta Pi and pi_k.

/// Where the chart is centred at the start: theta at the given state.
struct Chart {
  Vec3 theta = Vec3::Zero();  ///< rad; zero: at the state itself
};

/// J^T Omega J - Omega of one map, J its derivative in canonical coordinates by dual numbers: exact
/// to rounding (a few 1e-15 of what enters the products). Square, 2 (3 + cones) rows; at most three
/// cones. `map` carries the state.
using JetMap = std::function<void(dynamics::RotationStateOf<Jet>&)>;
Eigen::MatrixXd symplectic_defect(const dynamics::RotationState& state, const JetMap& map,
                                  const Chart& chart = {});

/// Frobenius norm of the defect of one step of the scheme.
double symplectic_defect(const RotationScheme& scheme, const dynamics::Gyrostat& g,
                         const dynamics::Loads& loads, const dynamics::RotationState& state,
                         double h, const Chart& chart = {});

/// The closed form of the defect of one Lie midpoint drift over h: d alpha with
///   alpha = f (M . dT - (T . M)(T . dT)/t^2),  f = 1 - sin(t/2)/(t/2),  M = It T/h + sigma,
/// in the chart at the state (t = |T|; derived in src/dynamics).
Eigen::MatrixXd lie_midpoint_defect(const dynamics::Gyrostat& g,
                                    const dynamics::RotationState& state, double h);

}  // namespace tdbd::battery
