#include "reference/dynamics/runge_kutta.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/dynamics/applied_torque.hpp"
#include "reference/dynamics/cross_matrix.hpp"

namespace tdbd::reference {
namespace {

Mat3 inertia_without_cones(const dynamics::Gyrostat& g) {
  Mat3 It = g.inertia_B;
  for (const dynamics::Cone& c : g.cones) It -= c.axial_inertia * c.axis_B * c.axis_B.transpose();
  return It;
}

/// Rate of the twist of R = Swing Twist about space z: (w_z + w . n) / (1 + n_z), n = R ez.
double twist_rate(const Mat3& R_WB, const Vec3& w_B) {
  const Vec3 w_W = R_WB * w_B, n_W = R_WB.col(2);
  return (w_W.z() + w_W.dot(n_W)) / (1.0 + n_W.z());
}

dynamics::ConeLoad cone_load(const dynamics::Loads& loads, std::size_t k) {
  return k < loads.cones.size() ? loads.cones[k] : dynamics::ConeLoad{};
}

/// d/dt of a state, as a state.
GyrostatState rates(const dynamics::Gyrostat& g, const dynamics::Loads& loads,
                    const GyrostatState& s) {
  const Vec3 w_B = bit_angular_velocity(g, s);
  GyrostatState d = s;
  d.R_WB = s.R_WB * cross_matrix(w_B);
  d.body_momentum_B =
      s.body_momentum_B.cross(w_B) + applied_torque(loads, s.time, s.R_WB, w_B, s.twist);
  for (std::size_t k = 0; k < g.cones.size(); ++k) {
    const dynamics::ConeLoad load = cone_load(loads, k);
    const Vec3& axis_B = g.cones[k].axis_B;
    const double spin = s.cone_momenta[k] / g.cones[k].axial_inertia - axis_B.dot(w_B);
    d.body_momentum_B += load.external * axis_B;
    d.cone_momenta[k] = load.internal + load.external - load.damping * spin;
    d.cone_angles[k] = spin;
  }
  d.twist = twist_rate(s.R_WB, w_B);
  return d;
}

/// The samples' times inside (t0, t1), and t1.
std::vector<double> stops(const dynamics::Loads& loads, double t0, double t1) {
  std::vector<double> times{t1};
  for (const dynamics::SampledTorque& s : loads.samples)
    for (const double t : s.times)
      if (t0 < t && t < t1) times.push_back(t);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace

GyrostatState matrix_state(const dynamics::RotationState& s) {
  const Mat3 R_WB = s.q_WB.toRotationMatrix();
  const double twist = 2.0 * std::atan2(s.q_WB.z(), s.q_WB.w()) +
                       4.0 * std::numbers::pi * static_cast<double>(s.turns);
  return {s.time, R_WB, R_WB.transpose() * s.momentum_W, s.cone_angles, s.cone_momenta, twist};
}

Vec3 bit_angular_velocity(const dynamics::Gyrostat& g, const GyrostatState& s) {
  Vec3 carried = s.body_momentum_B;
  for (std::size_t k = 0; k < g.cones.size(); ++k) carried -= s.cone_momenta[k] * g.cones[k].axis_B;
  return inertia_without_cones(g).ldlt().solve(carried);
}

double total_energy(const dynamics::Gyrostat& g, const dynamics::Loads& loads,
                    const GyrostatState& s) {
  const Vec3 w_B = bit_angular_velocity(g, s);
  double energy = 0.5 * w_B.dot(inertia_without_cones(g) * w_B) +
                  loads.gravity_moment * s.R_WB.row(2).dot(loads.gravity_arm_B) +
                  spring_energy(loads.stiffness_W, s.R_WB, s.twist);
  for (std::size_t k = 0; k < g.cones.size(); ++k)
    energy += 0.5 * s.cone_momenta[k] * s.cone_momenta[k] / g.cones[k].axial_inertia;
  return energy;
}

std::vector<double> unknowns(const GyrostatState& s, const dynamics::Loads& loads) {
  std::vector<double> y;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) y.push_back(s.R_WB(i, j));
  for (int i = 0; i < 3; ++i) y.push_back(s.body_momentum_B[i]);
  y.insert(y.end(), s.cone_angles.begin(), s.cone_angles.end());
  y.insert(y.end(), s.cone_momenta.begin(), s.cone_momenta.end());
  if (loads.stiffness_W.z() != 0.0) y.push_back(s.twist);
  return y;
}

GyrostatState state_of(std::span<const double> y, std::size_t cones, double time) {
  GyrostatState s;
  s.time = time;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) s.R_WB(i, j) = y[static_cast<std::size_t>(3 * i + j)];
  s.body_momentum_B = Vec3(y[9], y[10], y[11]);
  const auto angles = y.subspan(12, cones), momenta = y.subspan(12 + cones, cones);
  s.cone_angles.assign(angles.begin(), angles.end());
  s.cone_momenta.assign(momenta.begin(), momenta.end());
  if (y.size() > 12 + 2 * cones) s.twist = y.back();
  return s;
}

RightHandSide gyrostat_equations(const dynamics::Gyrostat& g, const dynamics::Loads& loads) {
  return [g, loads](double t, std::span<const double> y, std::span<double> dydt) {
    const GyrostatState s = state_of(y, g.cones.size(), t);
    std::ranges::copy(unknowns(rates(g, loads, s), loads), dydt.begin());
  };
}

RungeKuttaRun runge_kutta(const dynamics::Gyrostat& g, const dynamics::Loads& loads,
                          const GyrostatState& start, double t_end, OdeMethod method,
                          const OdeTolerance& tolerance) {
  const RightHandSide f = gyrostat_equations(g, loads);
  std::vector<double> y = unknowns(start, loads);
  RungeKuttaRun run;
  double t = start.time;
  for (const double stop : stops(loads, start.time, t_end)) {
    run.evaluations += integrate(f, method, tolerance, t, stop, y);
    t = stop;
  }
  run.state = state_of(y, g.cones.size(), t_end);
  const double winding = loads.stiffness_W.z() != 0.0 ? run.state.twist : start.twist;
  run.state.twist = swing_twist(run.state.R_WB, winding).twist;
  return run;
}

}  // namespace tdbd::reference
