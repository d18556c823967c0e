#include "simulation/step/implicit_loads.hpp"

#include "rotation/rotation_vector.hpp"

namespace tdbd::simulation {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

int freedoms_of(const ResistedMotion& m) { return static_cast<int>(m.response.free.size()); }
int cones_of(const ResistedMotion& m) { return static_cast<int>(m.bit.cones.size()); }
bool rock_moves(const ResistedMotion& m) { return freedoms_of(m) > 6 + cones_of(m); }

void set_jacobian(const ResistedMotion& m, const CutOfPart& c,
                  Eigen::Matrix<double, 3, Eigen::Dynamic>& J) {
  J.setZero(3, freedoms_of(m));
  J.leftCols<3>().setIdentity();
  J.middleCols<3>(3) = -rotation::skew(c.cut.point - m.centre_W);
  if (c.cone >= 0) {
    const Pose X_WK = m.X_WB * m.bit.cones[at(c.cone)].X_BK;
    J.col(6 + c.cone) = X_WK.R.col(2).cross(c.cut.point - X_WK.p);
  }
  if (rock_moves(m)) J(2, freedoms_of(m) - 1) = -1.0;
}

/// Forces and resistances at u, and their sums. Lazy products: Eigen's blocked ones cost a thousand
/// instructions on matrices as small as these.
void evaluate(const ResistedMotion& m, const VectorXd& u, Resistance which, ImplicitWork& w) {
  w.f.setZero(u.size());
  w.C.setZero(u.size(), u.size());
  for (std::size_t i = 0; i < m.cuts.size(); ++i) {
    const auto& J = w.jacobians[i];
    const Vec3 v = J.lazyProduct(u);
    w.drags[i] = drag_of(m.plan, m.cuts[i], v, m.dt, which);
    w.f += J.transpose().lazyProduct(w.drags[i].force.force);
    w.resisted = w.drags[i].resistance.lazyProduct(J);
    w.C += J.transpose().lazyProduct(w.resisted);
  }
}

/// (I + A C) x = b.
void solve(const ResistedMotion& m, const VectorXd& b, ImplicitWork& w, VectorXd& x) {
  w.matrix.setIdentity(b.size(), b.size());
  w.matrix.noalias() += m.response.A * w.C;
  w.lu.compute(w.matrix);
  x = w.lu.solve(b);
}

double length_in_metric(VectorXd& x, const ImplicitWork& w) {
  w.root.triangularView<Eigen::Lower>().solveInPlace(x);
  return x.norm();
}

/// |u - free - A f(u)| in the metric of A; leaves forces and resistances at u.
double residual(const ResistedMotion& m, const VectorXd& u, Resistance which, ImplicitWork& w) {
  evaluate(m, u, which, w);
  w.rest = u - m.response.free;
  w.rest.noalias() -= m.response.A * w.f;
  return length_in_metric(w.rest, w);
}

/// Newton's step from work.u, halved until it comes nearer. False: it does not.
bool take_newton_step(const ResistedMotion& m, double before, ImplicitWork& w) {
  w.trial = w.f;
  w.trial.noalias() += w.C * w.u;
  w.rest = m.response.free;
  w.rest.noalias() += m.response.A * w.trial;
  solve(m, w.rest, w, w.next);
  constexpr int most_halvings = 4;
  constexpr double least_gain = 0.1;
  double part = 1.0;
  for (int i = 0; i < most_halvings; ++i, part *= 0.5) {
    w.trial = w.u + part * (w.next - w.u);
    if (residual(m, w.trial, Resistance::secant, w) < (1.0 - least_gain * part) * before) {
      w.u.swap(w.trial);
      return true;
    }
  }
  return false;
}

void take_secant_step(const ResistedMotion& m, ImplicitWork& w) {
  evaluate(m, w.u, Resistance::secant, w);
  solve(m, m.response.free, w, w.u);
}

/// Takes the cones out of B: their own impulse is implicit in every step.
void eliminate_cones(int cones, MatrixXd& B, ImplicitWork& w) {
  if (cones == 0) return;
  w.coupled.setIdentity(cones, cones);
  w.coupled += B.block(6, 6, cones, cones);
  w.cone_lu.compute(w.coupled);
  w.across = B.middleRows(6, cones);
  w.coupled = w.cone_lu.solve(w.across);
  w.across = B.middleCols(6, cones);
  B.noalias() -= w.across * w.coupled;
  B.middleRows(6, cones).setZero();
  B.middleCols(6, cones).setZero();
}

}  // namespace

void prepare(const ResistedMotion& m, ImplicitWork& w) {
  w.jacobians.resize(std::max(w.jacobians.size(), m.cuts.size()));
  w.drags.resize(m.cuts.size());
  for (std::size_t i = 0; i < m.cuts.size(); ++i) set_jacobian(m, m.cuts[i], w.jacobians[i]);
  w.matrix = 0.5 * (m.response.A + m.response.A.transpose());
  w.cholesky.compute(w.matrix);
  w.root = w.cholesky.matrixL();
}

double steepness(const ResistedMotion& m, const VectorXd& u, ImplicitWork& w) {
  evaluate(m, u, Resistance::secant, w);
  w.product.noalias() = w.C * w.root;
  MatrixXd& B = w.steep;
  B.noalias() = w.root.transpose() * w.product;
  eliminate_cones(cones_of(m), B, w);
  if (B.norm() <= 1.0) return B.norm();  // bounds the singular value
  w.product.noalias() = B.transpose() * B;
  w.eigen.compute(w.product, Eigen::EigenvaluesOnly);
  return std::sqrt(w.eigen.eigenvalues()[B.rows() - 1]);
}

Search find_resisted_velocity(const ResistedMotion& m, ImplicitWork& w) {
  constexpr int secant_rounds = 2, most_rounds = 30;
  constexpr double settled = 1e-9;
  w.rest = m.response.free;
  const double scale = length_in_metric(w.rest, w);
  Search search{0, false};
  for (; search.rounds < most_rounds; ++search.rounds) {
    const bool is_newton = search.rounds >= secant_rounds;
    const double rest = residual(m, w.u, is_newton ? Resistance::tangent : Resistance::secant, w);
    search.is_settled = rest <= settled * scale;
    if (search.is_settled) break;
    if (!is_newton || !take_newton_step(m, rest, w)) take_secant_step(m, w);
  }
  take_secant_step(m, w);
  return search;
}

void take_loads(const ResistedMotion& m, const ImplicitWork& w, BitLoads& loads) {
  clear(m.bit, loads);
  for (std::size_t i = 0; i < m.cuts.size(); ++i) {
    const CutOfPart& c = m.cuts[i];
    const PartDrag& drag = w.drags[i];
    const Vec3 v = w.jacobians[i] * w.u, F = -drag.resistance * v;
    add({F, drag.force.point, drag.force.normal, drag.force.tangential, -F.dot(v)}, m.bit, m.X_WB,
        c, loads);
  }
}

}  // namespace tdbd::simulation
