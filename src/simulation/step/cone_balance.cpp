#include "simulation/step/cone_balance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace tdbd::simulation {
namespace {

/// Root of a rising function between two places of different sign: false position, halved where it
/// is slow (Illinois).
template <class F>
double root_between(const F& f, double a, double fa, double b, double fb) {
  constexpr int most_steps = 200;
  constexpr double relative = 1e-12;
  for (int i = 0; i < most_steps; ++i) {
    if (fb == 0.0 || std::abs(b - a) <= relative * (1.0 + std::abs(a) + std::abs(b))) return b;
    const double c = (fa * b - fb * a) / (fa - fb), fc = f(c);
    if ((fc < 0.0) != (fb < 0.0)) {
      a = b;
      fa = fb;
    } else {
      fa *= 0.5;
    }
    b = c;
    fb = fc;
  }
  throw RunError(
      fmt::format("the spin of a cone is not found between {:.6g} and {:.6g} rad/s", a, b));
}

}  // namespace

double cone_torque(const ForcePlan& plan, const bit::Bit& bit, int cone, const Pose& X_WB,
                   const BitVelocity& motion, double dt, const std::vector<CutOfPart>& cuts) {
  double torque = 0.0;
  for (const CutOfPart& c : cuts)
    if (c.cone == cone)
      torque += torque_about_cone(bit, X_WB, cone, load_of(plan, bit, X_WB, motion, dt, c));
  return torque;
}

std::vector<double> balanced_spins(const ForcePlan& plan, const bit::Bit& bit,
                                   const dynamics::DrillingSystem& system,
                                   const dynamics::DrillingState& before, const Pose& X_WB,
                                   double dt, BitVelocity motion,
                                   const std::vector<CutOfPart>& cuts) {
  for (int k = 0; k < static_cast<int>(bit.cones.size()); ++k) {
    const dynamics::Cone& cone = system.gyrostat.cones[at(k)];
    const double Ic = cone.axial_inertia, carried = (X_WB.R * cone.axis_B).dot(motion.w_W);
    const double free = before.rotation.cone_momenta[at(k)] / Ic - carried;
    const auto excess = [&](double spin) {
      motion.cone_speeds[at(k)] = spin;
      return spin - free - dt / Ic * cone_torque(plan, bit, k, X_WB, motion, dt, cuts);
    };
    const double start = excess(free), far = free - start;
    motion.cone_speeds[at(k)] =
        start == 0.0 ? free : root_between(excess, free, start, far, excess(far));
  }
  return motion.cone_speeds;
}

}  // namespace tdbd::simulation
