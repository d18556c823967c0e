#include "dynamics/drilling/response.hpp"

namespace tdbd::dynamics {
namespace {

bool rock_moves(const DrillingSystem& s) { return s.rock.mass > 0.0; }

}  // namespace

int freedoms(const DrillingSystem& s) { return 6 + cones_of(s) + (rock_moves(s) ? 1 : 0); }

void to_column(const DrillingSystem& s, const DrillingVelocity& v, Eigen::VectorXd& u) {
  u.resize(freedoms(s));
  u.head<3>() = v.v_W;
  u.segment<3>(3) = v.w_W;
  for (int k = 0; k < cones_of(s); ++k) u[6 + k] = v.cone_rates[at(k)];
  if (rock_moves(s)) u[6 + cones_of(s)] = v.rock;
}

void from_column(const DrillingSystem& s, const Eigen::VectorXd& u, DrillingVelocity& v) {
  v.v_W = u.head<3>();
  v.w_W = u.segment<3>(3);
  v.cone_rates.resize(s.gyrostat.cones.size());
  for (int k = 0; k < cones_of(s); ++k) v.cone_rates[at(k)] = u[6 + k];
  v.rock = rock_moves(s) ? u[6 + cones_of(s)] : 0.0;
}

void momenta_column(const DrillingSystem& s, const DrillingState& state, Eigen::VectorXd& p) {
  p.resize(freedoms(s));
  p.head<3>() = state.momentum_W;
  p.segment<3>(3) = state.rotation.momentum_W;
  for (int k = 0; k < cones_of(s); ++k) p[6 + k] = state.rotation.cone_momenta[at(k)];
  if (rock_moves(s)) p[6 + cones_of(s)] = state.rock_momentum;
}

void add_impulse_column(const DrillingSystem& s, const Eigen::VectorXd& impulse,
                        DrillingState& state) {
  state.momentum_W += impulse.head<3>();
  state.rotation.momentum_W += impulse.segment<3>(3);
  for (int k = 0; k < cones_of(s); ++k) state.rotation.cone_momenta[at(k)] += impulse[6 + k];
  if (rock_moves(s)) state.rock_momentum += impulse[6 + cones_of(s)];
}

void force_column(const DrillingSystem& s, const Wrench& conservative, const Wrench& wrench,
                  double cone_share, Eigen::VectorXd& force) {
  force.setZero(freedoms(s));
  force.head<3>() = conservative.force_W + wrench.force_W;
  force.segment<3>(3) = conservative.torque_W + wrench.torque_W;
  for (std::size_t k = 0; k < wrench.cones.size(); ++k)
    force[6 + static_cast<int>(k)] = cone_share * wrench.cones[k];
  if (rock_moves(s)) force[6 + cones_of(s)] = conservative.rock_force + wrench.rock_force;
}

void velocities_of(const DrillingSystem& s, const Configuration& at,
                   const Eigen::Ref<const Eigen::VectorXd>& p, Eigen::Ref<Eigen::VectorXd> u) {
  u.head<3>() = p.head<3>() / s.mass;
  Vec3 carried_B = Vec3::Zero();
  for (int k = 0; k < cones_of(s); ++k)
    carried_B += p[6 + k] * s.gyrostat.cones[tdbd::at(k)].axis_B;
  const Vec3 w_W = at.mobility_W * (p.segment<3>(3) - at.R_WB * carried_B);
  u.segment<3>(3) = w_W;
  const Vec3 w_B = at.R_WB.transpose() * w_W;
  for (int k = 0; k < cones_of(s); ++k) {
    const Cone& cone = s.gyrostat.cones[tdbd::at(k)];
    u[6 + k] = p[6 + k] / cone.axial_inertia - cone.axis_B.dot(w_B);
  }
  if (rock_moves(s)) u[6 + cones_of(s)] = p[6 + cones_of(s)] / s.rock.mass;
}

namespace {

/// The component of a wrench along a degree of freedom.
double& entry(const DrillingSystem& s, int freedom, Wrench& w) {
  if (freedom < 3) return w.force_W[freedom];
  if (freedom < 6) return w.torque_W[freedom - 3];
  return freedom < 6 + cones_of(s) ? w.cones[at(freedom - 6)] : w.rock_force;
}

/// Probe, N or N m. The map is affine, so the probe only needs to be large compared with rounding.
double probe_along(const DrillingSystem& s, int freedom) {
  constexpr double force = 1e3, torque = 1e2;
  return freedom < 3 || freedom == 6 + cones_of(s) ? force : torque;
}

}  // namespace

void find_response(const DrillingSystem& s, double h, const Drilling& d, RemainingKicks kicks,
                   DrillingWork& work, ResponseWork& scratch, Response& r) {
  const int n = freedoms(s);
  Wrench& w = scratch.wrench;
  w.force_W = w.torque_W = Vec3::Zero();
  w.cones.assign(s.gyrostat.cones.size(), 0.0);
  w.rock_force = 0.0;
  w.cone_impulse = kicks == RemainingKicks::opening ? ConeImpulse::halves : ConeImpulse::at_end;
  const auto ask = [&](Eigen::VectorXd& u) {
    velocity_after_kicks(s, h, d, kicks, w, work, scratch.velocity);
    to_column(s, scratch.velocity, u);
  };
  ask(r.free);
  r.A.resize(n, n);
  for (int j = 0; j < n; ++j) {
    double& probed = entry(s, j, w);
    probed = probe_along(s, j);
    ask(scratch.column);
    r.A.col(j) = (scratch.column - r.free) / probed;
    probed = 0.0;
  }
}

}  // namespace tdbd::dynamics
