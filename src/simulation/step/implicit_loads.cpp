#include "simulation/step/implicit_loads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rotation/screw.hpp"

namespace tdbd::simulation {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

int freedom_count_of(const ResistedMotion& m) { return static_cast<int>(m.response.free.size()); }
int cones_of(const ResistedMotion& m) { return static_cast<int>(m.bit.cones.size()); }
bool rock_moves(const ResistedMotion& m) { return freedom_count_of(m) > 6 + cones_of(m); }

void set_jacobian(const ResistedMotion& m, const CutOfPart& c,
                  Eigen::Matrix<double, 3, Eigen::Dynamic>& J) {
  J.setZero(3, freedom_count_of(m));
  J.leftCols<3>().setIdentity();
  J.middleCols<3>(3) = -rotation::skew(c.cut.point - m.centre_W);
  if (c.cone >= 0) {
    const Pose X_WK = m.X_WB * m.bit.cones[at(c.cone)].X_BK;
    J.col(6 + c.cone) = X_WK.R.col(2).cross(c.cut.point - X_WK.p);
  }
  if (rock_moves(m)) J(2, freedom_count_of(m) - 1) = -1.0;
}

enum class Sums { forces, forces_and_resistances };

/// Evaluates forces and resistances at u, and their sums. Uses lazy products, because Eigen's
/// blocked products take a thousand instructions for matrices of this size.
void evaluate(const ResistedMotion& m, const VectorXd& u, Resistance which, Sums sums,
              ImplicitWork& w) {
  w.f.setZero(u.size());
  if (sums == Sums::forces_and_resistances) w.C.setZero(u.size(), u.size());
  for (std::size_t i = 0; i < m.cuts.size(); ++i) {
    const auto& J = w.jacobians[i];
    const Vec3 v = J.lazyProduct(u);
    w.drags[i] =
        w.pressed[i] ? drag_of(*w.pressed[i], v) : drag_of(m.plan, m.cuts[i], v, m.dt, which);
    w.f += J.transpose().lazyProduct(w.drags[i].force.force);
    if (sums == Sums::forces) continue;
    w.resisted = w.drags[i].resistance.lazyProduct(J);
    w.C += J.transpose().lazyProduct(w.resisted);
  }
}

/// Solves (I + A C) x = b.
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

/// |u - free - A f(u)| in the metric of A. Leaves the sums at u in `w`.
double residual(const ResistedMotion& m, const VectorXd& u, Resistance which, Sums sums,
                ImplicitWork& w) {
  evaluate(m, u, which, sums, w);
  w.rest = u - m.response.free;
  w.rest.noalias() -= m.response.A * w.f;
  return length_in_metric(w.rest, w);
}

/// Solves the linearization at u with resistances C: (I + A C) next = free + A (f + C u). If all
/// resistances are secants, the right-hand side is `free`.
void solve_linearised(const ResistedMotion& m, ImplicitWork& w) {
  w.trial = w.f;
  w.trial.noalias() += w.C * w.u;
  w.rest = m.response.free;
  w.rest.noalias() += m.response.A * w.trial;
  solve(m, w.rest, w, w.next);
}

/// Newton step from work.u, halved until the residual decreases. If it never does: with pressing
/// surfaces, whose forces have kinks, the trial with the smallest residual is used; without, false
/// is returned.
bool take_newton_step(const ResistedMotion& m, double before, ImplicitWork& w) {
  solve_linearised(m, w);
  const bool presses = any_presses(w);
  const int most_halvings = presses ? 16 : 4;
  constexpr double least_gain = 0.1;
  double part = 1.0, nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_halvings; ++i, part *= 0.5) {
    w.trial = w.u + part * (w.next - w.u);
    const double rest = residual(m, w.trial, Resistance::secant, Sums::forces, w);
    if (rest < (1.0 - least_gain * part) * before) {
      w.u.swap(w.trial);
      return true;
    }
    if (rest >= nearest) continue;
    nearest = rest;
    w.nearest = w.trial;
  }
  if (presses) w.u.swap(w.nearest);
  return presses;
}

void take_secant_step(const ResistedMotion& m, ImplicitWork& w) {
  evaluate(m, w.u, Resistance::secant, Sums::forces_and_resistances, w);
  solve_linearised(m, w);
  w.u.swap(w.next);
}

/// A secant step with the estimated forces of the pressing surfaces.
void take_last_step(const ResistedMotion& m, ImplicitWork& w) {
  evaluate(m, w.u, Resistance::secant, Sums::forces, w);
  w.f.setZero();
  w.C.setZero(w.u.size(), w.u.size());
  for (std::size_t i = 0; i < m.cuts.size(); ++i) {
    const auto& J = w.jacobians[i];
    if (w.pressed[i]) {
      const PressedContact& c = *w.pressed[i];
      w.f += J.transpose().lazyProduct(Vec3(-c.p * c.normal_W - c.friction_W));
    } else {
      w.resisted = w.drags[i].resistance.lazyProduct(J);
      w.C += J.transpose().lazyProduct(w.resisted);
    }
  }
  w.rest = m.response.free;
  w.rest.noalias() += m.response.A * w.f;
  solve(m, w.rest, w, w.u);
}

/// Response of a contact to a force on it in one step.
ContactCompliance contact_compliance(const ResistedMotion& m, const Vec3& normal_W, std::size_t cut,
                                     ImplicitWork& w) {
  w.yields = w.jacobians[cut].lazyProduct(m.response.A);
  const Mat3 D = w.yields.lazyProduct(w.jacobians[cut].transpose());
  return {normal_W.dot(D * normal_W), D.norm()};
}

/// The largest diagonal entry of A among the velocities of the same kind as u[i]: those of points,
/// of the rotation of the bit, or of the cones.
double largest_of_kind(const ResistedMotion& m, const MatrixXd& A, Eigen::Index i) {
  const Eigen::Index cones = cones_of(m);
  if (i >= 3 && i < 6) return A.diagonal().segment(3, 3).maxCoeff();
  if (i >= 6 && i < 6 + cones) return A.diagonal().segment(6, cones).maxCoeff();
  const double largest = A.diagonal().head(3).maxCoeff();
  return rock_moves(m) ? std::max(largest, A(A.rows() - 1, A.rows() - 1)) : largest;
}

/// Computes the metric of lengths and steepness: the Cholesky factor L of the symmetric part of A.
/// If a damper or wall friction stops a motion within the step, that part is singular and its small
/// pivots are rounding. Then L^2 = n diag(A) with a lower limit is used, where n is the number of
/// velocities: an upper bound for a singular A.
void set_root(const ResistedMotion& m, ImplicitWork& w) {
  constexpr double rounding = 1e-12;  // relative to a pivot; lengths keep their accuracy of 1e-9
  w.matrix = 0.5 * (m.response.A + m.response.A.transpose());
  w.cholesky.compute(w.matrix);
  bool is_positive = w.cholesky.info() == Eigen::Success;
  w.root = w.cholesky.matrixL();
  const Eigen::Index n = w.matrix.rows();
  for (Eigen::Index i = 0; is_positive && i < n; ++i)
    is_positive = w.root(i, i) * w.root(i, i) > rounding * largest_of_kind(m, w.matrix, i);
  if (is_positive) return;
  w.root.setZero();
  for (Eigen::Index i = 0; i < n; ++i) {
    const double floor = rounding * largest_of_kind(m, w.matrix, i);
    w.root(i, i) = std::sqrt(static_cast<double>(n) * std::max(w.matrix(i, i), floor));
  }
}

/// Sets the penalties to `times` the value that stops the contact in one step.
void set_penalties(double times, ImplicitWork& w) {
  for (std::size_t i = 0; i < w.pressed.size(); ++i) {
    if (!w.pressed[i]) continue;
    w.pressed[i]->k_n = times / w.compliances[i].normal;
    w.pressed[i]->k_t = times / w.compliances[i].along;
  }
}

void update_estimates(const ResistedMotion& m, ImplicitWork& w) {
  for (std::size_t i = 0; i < m.cuts.size(); ++i)
    if (w.pressed[i]) update_estimate(*w.pressed[i], w.jacobians[i].lazyProduct(w.u));
}

/// Newton's method for fixed estimates of the pressing surfaces. `first_secants` is the number of
/// initial secant rounds.
bool find_velocity(const ResistedMotion& m, double close, int first_secants, int most_rounds,
                   int& rounds, ImplicitWork& w) {
  for (int round = 0; round < most_rounds; ++round, ++rounds) {
    const bool is_newton = round >= first_secants;
    const double rest = residual(m, w.u, is_newton ? Resistance::tangent : Resistance::secant,
                                 Sums::forces_and_resistances, w);
    if (rest <= close) return true;
    if (!is_newton || !take_newton_step(m, rest, w)) take_secant_step(m, w);
  }
  return false;
}

}  // namespace

bool any_presses(const ImplicitWork& w) {
  return std::ranges::any_of(w.pressed, [](const auto& contact) { return contact.has_value(); });
}

std::optional<forces::Pressing> pressing_of(const ForcePlan& plan, const CutOfPart& cut) {
  return forces::pressing(law_of(plan, cut), cut.cut);
}

void prepare(const ResistedMotion& m, ImplicitWork& w) {
  w.jacobians.resize(std::max(w.jacobians.size(), m.cuts.size()));
  w.drags.resize(m.cuts.size());
  for (std::size_t i = 0; i < m.cuts.size(); ++i) set_jacobian(m, m.cuts[i], w.jacobians[i]);
  set_root(m, w);
  w.pressed.assign(m.cuts.size(), std::nullopt);
  for (std::size_t i = 0; i < m.cuts.size(); ++i)
    if (const auto law = pressing_of(m.plan, m.cuts[i]); law && law->limit > 0.0)
      w.pressed[i] = PressedContact{*law, m.cuts[i].cut.normal, m.cuts[i].distance / m.dt};
  w.compliances.resize(m.cuts.size());
  for (std::size_t i = 0; i < m.cuts.size(); ++i)
    if (w.pressed[i]) w.compliances[i] = contact_compliance(m, w.pressed[i]->normal_W, i, w);
}

double steepness(const ResistedMotion& m, const VectorXd& u, ImplicitWork& w) {
  evaluate(m, u, Resistance::secant, Sums::forces_and_resistances, w);
  w.product.noalias() = w.C * w.root;
  MatrixXd& B = w.steep;
  B.noalias() = w.root.transpose() * w.product;
  if (B.norm() <= 1.0) return B.norm();  // upper bound of the largest singular value
  w.product.noalias() = B.transpose() * B;
  w.eigen.compute(w.product, Eigen::EigenvaluesOnly);
  return std::sqrt(w.eigen.eigenvalues()[B.rows() - 1]);
}

namespace {

/// Updates the estimates of the pressing surfaces until they converge.
bool settle(const ResistedMotion& m, double close, int first_secants, Search& search,
            ImplicitWork& w) {
  constexpr int most_rounds = 30, most_updates = 12;
  constexpr double penalty_growth = 10.0, largest_penalty = 1e5;
  const bool presses = any_presses(w);
  double penalty = penalty_growth;
  for (int update = 0; update < most_updates; ++update) {
    set_penalties(penalty, w);
    const bool is_near =
        find_velocity(m, close, update == 0 ? first_secants : 0, most_rounds, search.rounds, w);
    update_estimates(m, w);
    if (is_near && (!presses || residual(m, w.u, Resistance::none, Sums::forces, w) <= close))
      return true;
    if (!presses) return false;
    penalty = std::min(penalty_growth * penalty, largest_penalty);
  }
  return false;
}

/// Whether the friction of a pressing surface decreases with its slip. A contact may then both
/// stick and slip in one step.
bool weakens(const ImplicitWork& w) {
  return std::ranges::any_of(w.pressed, [](const auto& c) {
    return c && c->law.sliding.mu * c->law.sliding.weakening > 0.0;
  });
}

/// Fixes the slips at which friction and ramp are evaluated (initially 0), solves, and updates
/// them. From one solution to the next forces decrease and slips increase, so this finds the
/// smallest slip, and a contact that can stick does. It continues if an inner search does not
/// converge.
bool iterate_at_fixed_slip(const ResistedMotion& m, double close, Search& search, ImplicitWork& w) {
  constexpr int most_updates = 100, most_rounds = 2000;
  for (auto& c : w.pressed)
    if (c) c->slip = 0.0;
  bool has_converged = false;
  for (int update = 0; update < most_updates && !has_converged && search.rounds < most_rounds;
       ++update) {
    settle(m, close, 0, search, w);
    for (std::size_t i = 0; i < m.cuts.size(); ++i)
      if (auto& c = w.pressed[i]; c) {
        const Vec3 v = w.jacobians[i].lazyProduct(w.u);
        c->slip = forces::slip_velocity(v, c->normal_W).norm();
      }
    has_converged = residual(m, w.u, Resistance::none, Sums::forces, w) <= close;
  }
  for (auto& c : w.pressed)
    if (c) c->slip.reset();
  return has_converged;
}

}  // namespace

Search find_resisted_velocity(const ResistedMotion& m, ImplicitWork& w) {
  constexpr int secant_rounds = 2;
  constexpr double settled = 1e-9;
  w.rest = m.response.free;
  const double close = settled * length_in_metric(w.rest, w);
  Search search{0, false};
  search.has_converged = !weakens(w) && settle(m, close, secant_rounds, search, w);
  if (!search.has_converged && any_presses(w))
    search.has_converged = iterate_at_fixed_slip(m, close, search, w);
  take_last_step(m, w);
  return search;
}

void take_loads(const ResistedMotion& m, const ImplicitWork& w, BitLoads& loads) {
  clear(m.bit, loads);
  for (std::size_t i = 0; i < m.cuts.size(); ++i) {
    const CutOfPart& c = m.cuts[i];
    const Vec3 v = w.jacobians[i] * w.u;
    PartLoad load;
    if (w.pressed[i]) {
      const PressedContact& p = *w.pressed[i];
      load = {-p.p * p.normal_W - p.friction_W, c.cut.point, p.p, p.friction_W.norm(), 0.0};
    } else {
      const PartDrag& drag = w.drags[i];
      load = {-drag.resistance * v, drag.force.point, drag.force.normal, drag.force.tangential,
              0.0};
    }
    load.power = -load.force_W.dot(v);
    add(load, m.bit, m.X_WB, c, loads);
  }
}

}  // namespace tdbd::simulation
