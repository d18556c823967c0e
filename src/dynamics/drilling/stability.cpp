#include "dynamics/drilling/stability.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "dynamics/drilling/configuration.hpp"

namespace tdbd::dynamics {
namespace {

/// Order: x, y, z of the centre of mass, rotations about them, z of the rock.
using Matrix7 = Eigen::Matrix<double, 7, 7>;
constexpr std::array<const char*, 7> motions = {
    "along x",         "along y",         "along z",         "tilting about x",
    "tilting about y", "turning about z", "the rock along z"};

/// Jacobian of the displacement of a point of the bit with respect to the seven motions.
Eigen::Matrix<double, 3, 7> point_motion(const Vec3& arm) {
  Eigen::Matrix<double, 3, 7> J = Eigen::Matrix<double, 3, 7>::Zero();
  J.leftCols<3>().setIdentity();
  J.block<3, 3>(0, 3) << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
  return J;
}

/// Contribution of the contact between bit and rock.
Matrix7 contact_matrix(double lateral, double axial, double twist) {
  Matrix7 A = Matrix7::Zero();
  A(0, 0) = A(1, 1) = lateral;
  A(2, 2) = A(6, 6) = axial;
  A(2, 6) = A(6, 2) = -axial;
  A(5, 5) = twist;
  return A;
}

Matrix7 stiffness_matrix(const DrillingSystem& s, const ContactSlopes& c, const Mat3& R) {
  Matrix7 K = contact_matrix(c.lateral_stiffness, c.axial_stiffness, c.twist_stiffness);
  const auto held = point_motion(R * (s.string.attachment_B - s.centre_B));
  K += held.transpose() * s.spring * held;
  const auto ring = point_motion(R * (Vec3(0.0, 0.0, s.wall.ring_z_B) - s.centre_B));
  K += mean_wall_stiffness(s.wall) * (ring.topRows<2>().transpose() * ring.topRows<2>());
  K.block<3, 3>(3, 3) += s.string.turn_stiffness;
  K(6, 6) += s.rock.stiffness;
  return K;
}

/// Fixed rock gets a mass of 1 here; hold_rock removes its motion from the stiffness.
Matrix7 mass_matrix(const DrillingSystem& s, const Mat3& R) {
  Matrix7 M = Matrix7::Identity();
  M.topLeftCorner<3, 3>() *= s.mass;
  M.block<3, 3>(3, 3) = R * s.gyrostat.carrier_B * R.transpose();
  if (s.rock.mass > 0.0) M(6, 6) = s.rock.mass;
  return M;
}

void hold_rock(const DrillingSystem& s, Matrix7& A) {
  if (s.rock.mass > 0.0) return;
  A.row(6).setZero();  // the solver does not read the column, which is above the diagonal
}

/// Largest eigenvalue of A with respect to M, and the motion with the largest share of its energy.
struct Largest {
  double value = 0.0;
  int motion = 0;
};
Largest largest_eigenvalue(const Matrix7& A, const Matrix7& M) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix7> solver(A, M);
  const Eigen::Matrix<double, 7, 1> shape = solver.eigenvectors().col(6);
  Largest found{std::max(solver.eigenvalues()[6], 0.0), 0};
  (M.diagonal().array() * shape.array().square()).maxCoeff(&found.motion);
  return found;
}

}  // namespace

StabilityLimit stability_limit(const DrillingSystem& s, const ContactSlopes& c) {
  constexpr int attitudes = 16;  // over half a turn: an axis and its opposite are equivalent
  StabilityLimit limit;
  for (int i = 0; i < attitudes; ++i) {
    const double angle = std::numbers::pi * i / attitudes;
    const Mat3 R = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
    Matrix7 K = stiffness_matrix(s, c, R);
    Matrix7 D = contact_matrix(c.lateral_damping, c.axial_damping, c.twist_damping);
    hold_rock(s, K);
    hold_rock(s, D);
    const Matrix7 M = mass_matrix(s, R);
    const Largest vibration = largest_eigenvalue(K, M), slowing = largest_eigenvalue(D, M);
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

}  // namespace tdbd::dynamics
