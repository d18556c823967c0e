#include "verification/battery/rotation_checks.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace tdbd::battery {
namespace {

using dynamics::Rotating;

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double d = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) d = std::max(d, std::abs(a[i] - b[i]));
  return d;
}

}  // namespace

const GoldenState& golden_at(const GoldenCase& c, double time) {
  for (const GoldenState& s : c.states)
    if (s.time == time) return s;
  throw RunError("no golden state at this time");
}

dynamics::RotationState as_state(const GoldenState& golden) {
  dynamics::RotationState s;
  s.q_WB = Eigen::Quaterniond(golden.R_WB);
  rotation::renormalise(s.q_WB);
  s.momentum_W = golden.momentum_W;
  s.cone_angles = golden.cone_angles;
  s.cone_momenta = golden.cone_momenta;
  return s;
}

Rotating carry(const RotationScheme& scheme, const GoldenCase& c, double h, long steps) {
  Rotating r = dynamics::start(c.gyrostat, c.loads, c.initial);
  for (long i = 0; i < steps; ++i) scheme.step(c.gyrostat, c.loads, h, r);
  return r;
}

double reversibility_defect(const RotationScheme& scheme, const GoldenCase& c, double h,
                            long steps) {
  Rotating r = carry(scheme, c, h, steps);
  for (long i = 0; i < steps; ++i) scheme.step(c.gyrostat, c.loads, -h, r);
  const StateErrors e = state_errors(r.state, c.initial);
  return *std::max_element(e.begin(), e.end());
}

ConservationDefects conservation_defects(const RotationScheme& scheme, const GoldenCase& c,
                                         double h, long steps) {
  Rotating r = dynamics::start(c.gyrostat, c.loads, c.initial);
  ConservationDefects d;
  for (long i = 0; i < steps; ++i) {
    scheme.step(c.gyrostat, c.loads, h, r);
    const Vec3 change = (r.state.momentum_W - c.initial.momentum_W).cwiseAbs();
    d.space_momentum = std::max(d.space_momentum, change.maxCoeff());
    d.vertical_momentum = std::max(d.vertical_momentum, change.z());
    d.cone_momenta =
        std::max(d.cone_momenta, largest_difference(r.state.cone_momenta, c.initial.cone_momenta));
    d.unit_quaternion = std::max(d.unit_quaternion, std::abs(r.state.q_WB.squaredNorm() - 1.0));
  }
  return d;
}

double total_energy(const GoldenCase& c, const dynamics::RotationState& s) {
  return dynamics::kinetic_energy(c.gyrostat, s) + dynamics::potential_energy(c.loads, s);
}

EnergyRecord energy_record(const RotationScheme& scheme, const GoldenCase& c, double h,
                           long steps) {
  Rotating r = dynamics::start(c.gyrostat, c.loads, c.initial);
  const double E0 = total_energy(c, r.state);
  EnergyRecord record;
  for (long i = 0; i < steps; ++i) {
    scheme.step(c.gyrostat, c.loads, h, r);
    const double error = (total_energy(c, r.state) - E0) / std::abs(E0);
    record.mean_of_fifth[static_cast<std::size_t>(5 * i / steps)] +=
        error * 5.0 / static_cast<double>(steps);
    record.largest = std::max(record.largest, std::abs(error));
    if (100 * i < steps) record.largest_of_first_hundredth = record.largest;
  }
  return record;
}

}  // namespace tdbd::battery
