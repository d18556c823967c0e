#include "reference/dynamics/lumped_drilling.hpp"

#include <algorithm>
#include <cmath>

#include "reference/dynamics/cross_matrix.hpp"

namespace tdbd::reference {
namespace {

using dynamics::DrillingSystem;

/// A state, or its rate, with the energies: the unknowns of the Runge-Kutta methods.
struct Motion {
  LumpedState state;
  LumpedEnergy energy;
};

/// Calls `visit` with every number of a motion, in a fixed order.
template <class M, class Visit>
void each_number(M& m, const Visit& visit) {
  auto& [bit, c_W, v_W, rock_z, rock_v, top_z, top_angle] = m.state;
  for (int i = 0; i < 9; ++i) visit(bit.R_WB.data()[i]);
  for (int i = 0; i < 3; ++i) {
    visit(bit.body_momentum_B[i]);
    visit(c_W[i]);
    visit(v_W[i]);
  }
  for (auto& angle : bit.cone_angles) visit(angle);
  for (auto& momentum : bit.cone_momenta) visit(momentum);
  for (auto* x : {&bit.twist, &rock_z, &rock_v, &top_z, &top_angle}) visit(*x);
  auto& e = m.energy;
  for (auto* x : {&e.top, &e.gravity, &e.cut_bit, &e.cut_rock, &e.damped_string, &e.damped_bearings,
                  &e.damped_rock, &e.wall_loss, &e.wall_friction})
    visit(*x);
}

LumpedState rates(const DrillingSystem& system, const LumpedState& s, const LumpedForces& f) {
  LumpedState d = s;
  const Vec3 w_B = bit_angular_velocity(system.gyrostat, s.bit), w_W = s.bit.R_WB * w_B;
  d.bit.R_WB = s.bit.R_WB * cross_matrix(w_B);
  d.bit.body_momentum_B = s.bit.body_momentum_B.cross(w_B) + s.bit.R_WB.transpose() * f.torque_W;
  for (std::size_t k = 0; k < f.cones.size(); ++k) {
    const dynamics::Cone& cone = system.gyrostat.cones[k];
    d.bit.cone_angles[k] = s.bit.cone_momenta[k] / cone.axial_inertia - cone.axis_B.dot(w_B);
    d.bit.cone_momenta[k] = f.cones[k];
  }
  const Vec3 n_W = s.bit.R_WB.col(2);
  d.bit.twist = (w_W.z() + w_W.dot(n_W)) / (1.0 + n_W.z());
  d.c_W = s.v_W;
  d.v_W = f.force_W / system.mass;
  d.rock_z = s.rock_v;
  d.rock_v = system.rock.mass > 0.0 ? f.rock_force / system.rock.mass : 0.0;
  d.top_z = scheduled(system.top.rate, s.bit.time);
  d.top_angle = scheduled(system.top.speed, s.bit.time);
  return d;
}

std::vector<double> numbers(const Motion& m) {
  std::vector<double> y;
  each_number(m, [&](double x) { y.push_back(x); });
  return y;
}

Motion motion_of(std::span<const double> y, const Motion& like, double time) {
  Motion m = like;
  std::size_t i = 0;
  each_number(m, [&](double& x) { x = y[i++]; });
  m.state.bit.time = time;
  return m;
}

/// The equations up to `stop`, where a stepwise schedule of the top still has its value before the
/// step.
RightHandSide equations(const DrillingSystem& system, const LumpedLaw& law, const Motion& like,
                        double stop) {
  const double last = std::nextafter(stop, like.state.bit.time);
  return [&system, &law, like, last](double t, std::span<const double> y, std::span<double> dydt) {
    const Motion m = motion_of(y, like, std::min(t, last));
    const LumpedForces f = lumped_forces(system, law, m.state);
    std::ranges::copy(numbers({rates(system, m.state, f), f.power}), dydt.begin());
  };
}

/// The schedules' times inside (t0, t1), and t1.
std::vector<double> stops(const dynamics::TopDrive& top, double t0, double t1) {
  std::vector<double> times{t1};
  for (const dynamics::Schedule* s : {&top.speed, &top.rate, &top.load})
    for (const double t : s->times)
      if (t0 < t && t < t1) times.push_back(t);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace

LumpedState lumped_state(const DrillingSystem& system, const dynamics::DrillingState& s) {
  LumpedState l;
  l.bit = matrix_state(s.rotation);
  l.c_W = s.c_W;
  l.v_W = s.momentum_W / system.mass;
  l.rock_z = s.rock_z;
  l.top_angle = system.top.start_angle;
  if (system.rock.mass > 0.0) l.rock_v = s.rock_momentum / system.rock.mass;
  return l;
}

LumpedRun lumped_drilling(const DrillingSystem& system, const LumpedLaw& law,
                          const LumpedState& start, double t_end, const OdeTolerance& tolerance) {
  const Motion from{start, {}};
  std::vector<double> y = numbers(from);
  LumpedRun run;
  double t = start.bit.time;
  for (const double stop : stops(system.top, t, t_end)) {
    run.evaluations +=
        integrate(equations(system, law, from, stop), OdeMethod::rk8pd, tolerance, t, stop, y);
    t = stop;
  }
  const Motion end = motion_of(y, from, t_end);
  run.state = end.state;
  run.energy = end.energy;
  return run;
}

LumpedRun lumped_drilling_rk4(const DrillingSystem& system, const LumpedLaw& law,
                              const LumpedState& start, double t_end, int steps) {
  const Motion from{start, {}};
  std::vector<double> y = numbers(from);
  LumpedRun run;
  run.evaluations =
      integrate_rk4(equations(system, law, from, t_end), steps, start.bit.time, t_end, y);
  const Motion end = motion_of(y, from, t_end);
  run.state = end.state;
  run.energy = end.energy;
  return run;
}

}  // namespace tdbd::reference
