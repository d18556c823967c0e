#include "claims/carry.hpp"

#include <cmath>

namespace tdbd::claims {

dynamics::Rotating carry(const dynamics::Gyrostat& g, const dynamics::Loads& loads,
                         const dynamics::Integrator& integrator,
                         const dynamics::RotationState& start, double h, long steps) {
  dynamics::Rotating r = dynamics::start(g, loads, start);
  for (long i = 0; i < steps; ++i) dynamics::step(g, loads, integrator, h, r);
  return r;
}

dynamics::Rotating carry_to(const dynamics::Gyrostat& g, const dynamics::Loads& loads,
                            const dynamics::Integrator& integrator,
                            const dynamics::RotationState& start, double t_end, long steps) {
  return carry(g, loads, integrator, start, t_end / static_cast<double>(steps), steps);
}

double attitude_error(const Mat3& R, const Mat3& exact) {
  return (R - exact).norm() / std::sqrt(2.0);
}

const Mat3& golden_end(const battery::GoldenCase& c) { return c.states.back().R_WB; }

}  // namespace tdbd::claims
