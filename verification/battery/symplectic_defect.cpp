#include "verification/battery/symplectic_defect.hpp"

namespace tdbd::battery {
namespace {

using dynamics::RotationState;
using dynamics::RotationStateOf;
using Vec3J = Eigen::Matrix<Jet, 3, 1>;
using Mat3J = Eigen::Matrix<Jet, 3, 3>;

/// The i-th of the chart's variables.
Jet variable(double value, long i) {
  Jet x(value);
  x.by[i] = 1.0;
  return x;
}

/// dexp_v = 1 + c_2 skew(v) + c_3 skew(v)^2; its transpose takes w_B to the rate of v in R0 exp(v).
Mat3J dexp(const Vec3J& v) {
  const rotation::Stumpff<Jet> c = rotation::stumpff<Jet>(v.squaredNorm());
  const Mat3J X = dynamics::cross_matrix<Jet>(v);
  return Mat3J::Identity() + c.c2 * X + c.c3 * (X * X);
}

/// The rotation vector of a unit quaternion near the identity or not (less than half a turn).
Vec3J rotation_vector(Eigen::Quaternion<Jet> q) {
  if (q.w() < Jet(0.0)) q.coeffs() = -q.coeffs();
  const Jet s2 = q.vec().squaredNorm();
  if (s2.value < 1e-24) return 2.0 * q.vec();
  const Jet s = sqrt(s2);
  return (2.0 * atan2(s, q.w()) / s) * q.vec();
}

/// A state as a function of its canonical coordinates.
RotationStateOf<Jet> seeded(const RotationState& state, const Chart& chart) {
  const auto cones = static_cast<long>(state.cone_momenta.size());
  const long half = 3 + cones;
  const Vec3 theta0 = chart.theta;
  const Eigen::Quaterniond base = state.q_WB * rotation::quaternion_exp<double>(-theta0);
  Vec3J theta, p;
  for (int i = 0; i < 3; ++i) theta[i] = variable(theta0[i], i);
  const Vec3 momentum_B = state.q_WB.conjugate() * state.momentum_W;
  const Vec3J p0 = dexp(theta0.cast<Jet>()) * momentum_B.cast<Jet>();
  for (int i = 0; i < 3; ++i) p[i] = variable(p0[i].value, half + i);
  RotationStateOf<Jet> s;
  s.q_WB = base.cast<Jet>() * rotation::quaternion_exp<Jet>(theta);
  s.momentum_W = s.q_WB * Vec3J(dexp(theta).inverse() * p);
  for (long k = 0; k < cones; ++k) {
    const auto c = static_cast<std::size_t>(k);
    s.cone_angles.push_back(variable(state.cone_angles[c], 3 + k));
    s.cone_momenta.push_back(variable(state.cone_momenta[c], half + 3 + k));
  }
  s.time = state.time;
  return s;
}

/// Derivative of the canonical coordinates of a state, in the chart at the state itself.
Eigen::MatrixXd jacobian(const RotationStateOf<Jet>& s) {
  const auto cones = static_cast<long>(s.cone_momenta.size());
  const long half = 3 + cones;
  Eigen::Quaternion<Jet> base;
  for (int i = 0; i < 4; ++i) base.coeffs()[i] = Jet(s.q_WB.coeffs()[i].value);
  const Vec3J theta = rotation_vector(base.conjugate() * s.q_WB);
  const Vec3J p = dexp(theta) * Vec3J(s.q_WB.conjugate() * s.momentum_W);
  Eigen::MatrixXd J(2 * half, 2 * half);
  const auto row = [&](long i, const Jet& x) { J.row(i) = x.by.head(2 * half).matrix(); };
  for (int i = 0; i < 3; ++i) row(i, theta[i]), row(half + i, p[i]);
  for (long k = 0; k < cones; ++k) {
    row(3 + k, s.cone_angles[static_cast<std::size_t>(k)]);
    row(half + 3 + k, s.cone_momenta[static_cast<std::size_t>(k)]);
  }
  return J;
}

Eigen::MatrixXd canonical_form(long half) {
  Eigen::MatrixXd omega = Eigen::MatrixXd::Zero(2 * half, 2 * half);
  omega.topRightCorner(half, half).setIdentity();
  omega.bottomLeftCorner(half, half) = -Eigen::MatrixXd::Identity(half, half);
  return omega;
}

/// The one-form's coefficients a(T, sigma), alpha = a . dT, as jets by T (0-2) and sigma (3-5).
Vec3J alpha(const Vec3& T0, const Vec3& sigma0, const Mat3& It, double h) {
  Vec3J T, sigma;
  for (int i = 0; i < 3; ++i) {
    T[i] = variable(T0[i], i);
    sigma[i] = variable(sigma0[i], 3 + i);
  }
  const Jet t2 = T.squaredNorm();
  const Jet f = 1.0 - rotation::cos_sinc<Jet>(0.25 * t2).sinc;
  const Vec3J M = (It / h).cast<Jet>() * T + sigma;
  return f * (M - (T.dot(M) / t2) * T);
}

}  // namespace

Eigen::MatrixXd symplectic_defect(const RotationState& state, const JetMap& map,
                                  const Chart& chart) {
  RotationStateOf<Jet> s = seeded(state, chart);
  map(s);
  const Eigen::MatrixXd J = jacobian(s);
  const Eigen::MatrixXd omega = canonical_form(J.rows() / 2);
  return J.transpose() * omega * J - omega;
}

double symplectic_defect(const RotationScheme& scheme, const dynamics::Gyrostat& g,
                         const dynamics::Loads& loads, const RotationState& state, double h,
                         const Chart& chart) {
  const JetMap map = [&](RotationStateOf<Jet>& s) {
    dynamics::RotatingOf<Jet> r = dynamics::start(g, loads, s);
    scheme.step_jet(g, loads, h, r);
    s = r.state;
  };
  return symplectic_defect(state, map, chart).norm();
}

Eigen::MatrixXd lie_midpoint_defect(const dynamics::Gyrostat& g, const RotationState& state,
                                    double h) {
  const RotationStateOf<Jet> s = seeded(state, {});
  const Vec3J sigma = dynamics::cone_momentum_sum(g, s);
  Vec3J T;
  dynamics::solve_lie<Jet>(g, dynamics::LieMomentum::middle, h, dynamics::body_momentum(s), sigma,
                           {}, T);
  const long size = 2 * (3 + static_cast<long>(g.cones.size()));
  Eigen::MatrixXd by_z(6, size);  // of T and of sigma, by the canonical coordinates
  Vec3 T0, sigma0;
  for (int i = 0; i < 3; ++i) {
    by_z.row(i) = T[i].by.head(size).matrix();
    by_z.row(3 + i) = sigma[i].by.head(size).matrix();
    T0[i] = T[i].value;
    sigma0[i] = sigma[i].value;
  }
  const Vec3J a = alpha(T0, sigma0, g.carrier_B, h);
  Eigen::MatrixXd a_by = Eigen::MatrixXd::Zero(6, 6);  // (j, i) = d a_j / d (T, sigma)_i
  for (int j = 0; j < 3; ++j) a_by.row(j) = a[j].by.head(6).matrix();
  return by_z.transpose() * (a_by.transpose() - a_by) * by_z;
}

}  // namespace tdbd::battery
