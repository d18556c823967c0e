#pragma once

#include "dynamics/integrator.hpp"
#include "dynamics/rotation/step.hpp"
#include "verification/battery/golden.hpp"

namespace tdbd::claims {

/// The thesis's form, as reconstructed: Lie midpoint, two drifts a step.
inline constexpr dynamics::Integrator thesis{dynamics::Drift::lie_midpoint, 2};

/// So many steps of size h (s) from a state.
dynamics::Rotating carry(const dynamics::Gyrostat& g, const dynamics::Loads& loads,
                         const dynamics::Integrator& integrator,
                         const dynamics::RotationState& start, double h, long steps);

/// So many equal steps to time t_end, s.
dynamics::Rotating carry_to(const dynamics::Gyrostat& g, const dynamics::Loads& loads,
                            const dynamics::Integrator& integrator,
                            const dynamics::RotationState& start, double t_end, long steps);

/// ||R - R'||_F / sqrt 2: the angle between two attitudes, rad, while it is small.
double attitude_error(const Mat3& R, const Mat3& exact);

/// The golden attitude at t = 10 s.
const Mat3& golden_end(const battery::GoldenCase& c);

}  // namespace tdbd::claims
