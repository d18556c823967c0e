#include "dynamics/drilling/stability.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

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

namespace {

/// Order: x, y, z of the centre of mass, rotations about them, z of the rock. Matrices of fixed
/// size would be unrolled: a minute of compile time for a function that runs once per case.
constexpr int motion_count = 7;
using Eigen::MatrixXd;
constexpr std::array<const char*, motion_count> motions = {
    "along x",         "along y",         "along z",         "tilting about x",
    "tilting about y", "turning about z", "the rock along z"};

/// Jacobian of the displacement of a point of the bit with respect to the six motions of the bit.
MatrixXd point_motion(const Vec3& arm) {
  MatrixXd J = MatrixXd::Zero(3, 6);
  J.leftCols<3>().setIdentity();
  J.rightCols<3>() << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
  return J;
}

/// Contribution of the contact between bit and rock.
MatrixXd contact_matrix(double lateral, double axial, double twist) {
  MatrixXd A = MatrixXd::Zero(motion_count, motion_count);
  A(0, 0) = A(1, 1) = lateral;
  A(2, 2) = A(6, 6) = axial;
  A(2, 6) = A(6, 2) = -axial;
  A(5, 5) = twist;
  return A;
}

MatrixXd stiffness_matrix(const DrillingSystem& s, const ContactSlopes& c, const Mat3& R) {
  MatrixXd K = contact_matrix(c.lateral_stiffness, c.axial_stiffness, c.twist_stiffness);
  const MatrixXd held = point_motion(R * (s.string.attachment_B - s.centre_B));
  const MatrixXd pull = s.spring * held;
  K.topLeftCorner(6, 6) += held.transpose() * pull;
  const MatrixXd ring = point_motion(R * (Vec3(0.0, 0.0, s.wall.ring_z_B) - s.centre_B)).topRows(2);
  const MatrixXd push = mean_wall_stiffness(s.wall) * ring;
  K.topLeftCorner(6, 6) += ring.transpose() * push;
  K.block<3, 3>(3, 3) += s.string.turn_stiffness;
  K(6, 6) += s.rock.stiffness;
  return K;
}

/// The moving masses. Fixed rock gets a mass of 1 here; fix_rock removes its motion from the
/// stiffness.
struct Masses {
  Eigen::VectorXd diagonal;  ///< kg and kg m2, of the motions
  MatrixXd scale;            ///< W with W^T M W = 1
};

Masses masses_of(const DrillingSystem& s, const Mat3& R) {
  const Mat3 inertia = R * s.gyrostat.carrier_B * R.transpose();
  const double rock = s.rock.mass > 0.0 ? s.rock.mass : 1.0;
  Masses m{Eigen::VectorXd::Constant(motion_count, s.mass),
           MatrixXd::Zero(motion_count, motion_count)};
  m.diagonal.segment<3>(3) = inertia.diagonal();
  m.diagonal[6] = rock;
  m.scale.diagonal().setConstant(1.0 / std::sqrt(s.mass));
  m.scale.block<3, 3>(3, 3) = Mat3(Eigen::LLT<Mat3>(inertia).matrixU()).inverse();
  m.scale(6, 6) = 1.0 / std::sqrt(rock);
  return m;
}

void fix_rock(const DrillingSystem& s, MatrixXd& A) {
  if (s.rock.mass > 0.0) return;
  A.row(6).setZero();
  A.col(6).setZero();
}

/// Largest eigenvalue of A with respect to the masses, and the motion with the largest share of its
/// energy.
struct Largest {
  double value = 0.0;
  int motion = 0;
};
Largest largest_eigenvalue(const MatrixXd& A, const Masses& m) {
  const MatrixXd AW = A * m.scale;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(m.scale.transpose() * AW);
  const Eigen::VectorXd shape = m.scale * solver.eigenvectors().col(motion_count - 1);
  Largest found{std::max(solver.eigenvalues()[motion_count - 1], 0.0), 0};
  (m.diagonal.array() * shape.array().square()).maxCoeff(&found.motion);
  return found;
}

}  // namespace

StabilityLimit stability_limit(const DrillingSystem& s, const ContactSlopes& c) {
  constexpr int attitudes = 16;  // over half a turn: an axis and its opposite are equivalent
  StabilityLimit limit;
  for (int i = 0; i < attitudes; ++i) {
    const double angle = std::numbers::pi * i / attitudes;
    const Mat3 R = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
    MatrixXd K = stiffness_matrix(s, c, R);
    MatrixXd D = contact_matrix(c.lateral_damping, c.axial_damping, c.twist_damping);
    fix_rock(s, K);
    fix_rock(s, D);
    const Masses masses = masses_of(s, R);
    const Largest vibration = largest_eigenvalue(K, masses);
    const Largest slowing = largest_eigenvalue(D, masses);
    if (std::sqrt(vibration.value) > limit.frequency) {
      limit.frequency = std::sqrt(vibration.value);
      limit.mode = motions[static_cast<std::size_t>(vibration.motion)];
    }
    limit.rate = std::max(limit.rate, slowing.value);
  }
  constexpr double never = std::numeric_limits<double>::infinity();
  limit.step = std::min(limit.frequency > 0.0 ? 2.0 / limit.frequency : never,
                        limit.rate > 0.0 ? 1.0 / limit.rate : never);
  return limit;
}

std::string stability_problem(const DrillingSystem& s, const ContactSlopes& c, double h) {
  constexpr double safe = 0.8;  // of the limit, because the slopes of a law vary
  const StabilityLimit limit = stability_limit(s, c);
  if (h < limit.step) return "";
  const bool vibrates = limit.frequency * limit.step >= 1.5;
  const std::string cause =
      vibrates ? fmt::format(
                     "its fastest vibration ({}) has {:.4g} rad/s, and h omega must stay "
                     "below 2",
                     limit.mode, limit.frequency)
               : fmt::format(
                     "the force law slows the bit at {:.4g} 1/s, and h times that must "
                     "stay below 1",
                     limit.rate);
  return fmt::format("a step of {:.4g} s is unstable: {}; the limit is {:.4g} s, {:.2g} s is safe",
                     h, cause, limit.step, safe * limit.step);
}

namespace {

bool finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

/// Name of the first quantity that is not finite.
std::string not_finite(const Drilling& d) {
  const RotationState& r = d.state.rotation;
  const Wrench& w = d.wrench;
  if (!w.force_W.allFinite() || !std::isfinite(w.rock_force)) return "the force of cutting";
  if (!w.torque_W.allFinite()) return "the torque of cutting";
  if (!finite(w.cones)) return "a cone's torque of cutting";
  if (!d.state.c_W.allFinite() || !d.state.momentum_W.allFinite()) return "the bit's motion";
  if (!r.q_WB.coeffs().allFinite() || !r.momentum_W.allFinite()) return "the bit's rotation";
  if (!finite(r.cone_angles) || !finite(r.cone_momenta)) return "a cone's rotation";
  if (!std::isfinite(d.state.rock_z) || !std::isfinite(d.state.rock_momentum))
    return "the rock's motion";
  return "";
}

std::string beyond(const char* what, double value, double bound, const char* unit) {
  if (std::abs(value) <= bound) return "";
  return fmt::format("{}: {:.4g} {}, beyond {:.4g}", what, value, unit, bound);
}

std::string excessive_speed(const DrillingVelocity& v, const DivergenceBounds& b) {
  for (const std::string& why :
       {beyond("the bit's speed along x", v.v_W.x(), b.speed, "m/s"),
        beyond("the bit's speed along y", v.v_W.y(), b.speed, "m/s"),
        beyond("the bit's speed along z", v.v_W.z(), b.speed, "m/s"),
        beyond("the bit's tilt rate", v.w_W.head<2>().norm(), b.angular_speed, "rad/s"),
        beyond("the bit's rotary speed", v.w_W.z(), b.angular_speed, "rad/s"),
        beyond("the rock's speed", v.rock, b.speed, "m/s")})
    if (!why.empty()) return why;
  for (std::size_t k = 0; k < v.cone_rates.size(); ++k)
    if (std::abs(v.cone_rates[k]) > b.angular_speed)
      return fmt::format("cone {}'s speed: {:.4g} rad/s, beyond {:.4g}", k + 1, v.cone_rates[k],
                         b.angular_speed);
  return "";
}

/// Name of the largest energy contribution.
const char* largest_store(const StoredEnergy& e) {
  const std::array<std::pair<double, const char*>, 7> stores{
      {{e.translation, "the bit's translation"},
       {e.rotation, "the bit's rotation"},
       {e.cones, "the cones"},
       {e.rock, "the rock's motion"},
       {e.string, "the string"},
       {e.wall, "the wall"},
       {e.rock_mount, "the rock's mount"}}};
  return std::max_element(stores.begin(), stores.end())->second;
}

}  // namespace

std::string divergence(const DrillingSystem& system, const Drilling& d, const DrillingWork& work,
                       const DivergenceBounds& bounds) {
  const auto at = [&](const std::string& why) {
    return fmt::format("{} at t = {:.9g} s", why, d.state.rotation.time);
  };
  if (const std::string what = not_finite(d); !what.empty()) return at(what + " is not finite");
  if (const std::string why = excessive_speed(work.closing, bounds); !why.empty()) return at(why);
  const StoredEnergy now = stored_energy(system, work.at, d.state);
  const double left = residual(now, d.ledger);
  const double moved = throughput(d.ledger);
  if (std::abs(left) <= bounds.energy_residual * moved + bounds.least_energy) return "";
  return at(
      fmt::format("the energy residual: {:.4g} J with {:.4g} J of energy in and out, mostly in {}",
                  left, moved, largest_store(now)));
}

}  // namespace tdbd::dynamics
