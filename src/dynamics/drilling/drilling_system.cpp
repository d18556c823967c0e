#include "dynamics/drilling/drilling_system.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/error.hpp"
#include "core/tolerance.hpp"

namespace tdbd::dynamics {
namespace {

std::string matrix_problem(const char* name, const Mat3& A) {
  if (!A.allFinite()) return fmt::format("{} that is not finite", name);
  const double scale = A.cwiseAbs().maxCoeff();
  if ((A - A.transpose()).cwiseAbs().maxCoeff() > tolerance::inertia * scale)
    return fmt::format("{} that is not symmetric", name);
  const double least =
      Eigen::SelfAdjointEigenSolver<Mat3>(A, Eigen::EigenvaluesOnly).eigenvalues()[0];
  if (least < -tolerance::inertia * scale)
    return fmt::format("{} that is not positive: principal value {:.6g}", name, least);
  return "";
}

/// Checks that a number is finite and not negative.
std::string number_problem(const char* name, double value) {
  return std::isfinite(value) && value >= 0.0 ? "" : fmt::format("{} of {}", name, value);
}

std::string string_problem(const DrillString& s) {
  for (const std::string& why :
       {matrix_problem("a string's stiffness", s.stiffness),
        matrix_problem("a string's damping", s.damping),
        matrix_problem("a string's rotational stiffness", s.turn_stiffness),
        matrix_problem("a string's rotational damping", s.turn_damping)})
    if (!why.empty()) return why;
  if (!s.attachment_B.allFinite() || !s.rest_W.allFinite())
    return "a string's attachment or rest that is not finite";
  return "";
}

std::string wall_problem(const Wall& w) {
  for (const std::string& why : {number_problem("a wall's stiffness", w.stiffness),
                                 number_problem("a wall's clearance", w.clearance),
                                 number_problem("a wall's ring of radius", w.ring_radius),
                                 number_problem("a wall's restitution", w.restitution),
                                 number_problem("a wall's friction", w.friction),
                                 number_problem("a wall's slip speed", w.slip_speed)})
    if (!why.empty()) return why;
  if (w.restitution > 1.0)
    return fmt::format("a wall's restitution of {}: at most 1", w.restitution);
  return "";
}

std::string bearing_problem(const DrillingSystem& s) {
  if (!s.bearing_damping.empty() && s.bearing_damping.size() != s.gyrostat.cones.size())
    return fmt::format("{} bearing dampings for {} cones", s.bearing_damping.size(),
                       s.gyrostat.cones.size());
  for (const double d : s.bearing_damping)
    if (std::string why = number_problem("a bearing's damping", d); !why.empty()) return why;
  return "";
}

std::array<PrincipalDamper, 3> principal_dampers(const Mat3& damping) {
  const Mat3 across = damping - Mat3(damping.diagonal().asDiagonal());
  std::array<PrincipalDamper, 3> dampers;
  Mat3 axes = Mat3::Identity();
  Vec3 values = damping.diagonal();
  if (!across.isZero(0.0)) {
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(damping);
    axes = solver.eigenvectors();
    values = solver.eigenvalues().cwiseMax(0.0);
  }
  for (int i = 0; i < 3; ++i) dampers[static_cast<std::size_t>(i)] = {axes.col(i), values[i]};
  return dampers;
}

}  // namespace

std::string drilling_problem(const DrillingSystem& s) {
  if (!std::isfinite(s.mass) || s.mass <= 0.0) return fmt::format("a mass of {} kg", s.mass);
  for (const double gravity : {s.gravity, s.gravity_across})
    if (!std::isfinite(gravity)) return fmt::format("gravity of {} m/s2", gravity);
  if (!s.centre_B.allFinite()) return "a centre of mass that is not finite";
  if (s.integrator.order != 2)
    return fmt::format("an integrator of order {}: drilling has order 2", s.integrator.order);
  for (const std::string& why : {string_problem(s.string), wall_problem(s.wall), bearing_problem(s),
                                 number_problem("a top's following time", s.top.following_time),
                                 number_problem("a rock's mass", s.rock.mass),
                                 number_problem("a rock mount's stiffness", s.rock.stiffness),
                                 number_problem("a rock mount's damping", s.rock.damping)})
    if (!why.empty()) return why;
  return "";
}

DrillingSystem make_drilling_system(DrillingSystem s) {
  if (const std::string why = drilling_problem(s); !why.empty()) throw InputError(why);
  s.spring = 0.5 * (s.string.stiffness + s.string.stiffness.transpose());
  if (s.top.axial == AxialMode::load) {
    s.spring.row(2).setZero();
    s.spring.col(2).setZero();
  }
  s.dampers = principal_dampers(s.string.damping);
  s.turn_dampers = principal_dampers(s.string.turn_damping);
  if (s.bearing_damping.empty()) s.bearing_damping.assign(s.gyrostat.cones.size(), 0.0);
  return s;
}

}  // namespace tdbd::dynamics
