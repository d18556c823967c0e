#include "dynamics/gyrostat.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/error.hpp"
#include "core/tolerance.hpp"
#include "dynamics/momenta.hpp"
#include "rotation/quaternion.hpp"

namespace tdbd::dynamics {
namespace {

/// Principal values, ascending, and right-handed axes of a symmetric matrix.
void principal_frame(const Mat3& A, Vec3& values, Mat3& axes) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(A);
  values = solver.eigenvalues();
  axes = solver.eigenvectors();
  if (axes.determinant() < 0.0) axes.col(0) = -axes.col(0);
}

/// Makes principal values equal if they differ only by rounding. The drifts of a symmetric body are
/// shorter, and exact in cases where those of a nearly symmetric body are not.
void equalize_principal_values(Vec3& ascending) {
  const double rounding = tolerance::equal_inertia * ascending[2];
  if (ascending[1] - ascending[0] <= rounding) ascending[0] = ascending[1];
  if (ascending[2] - ascending[1] <= rounding) ascending[2] = ascending[1];
}

Vec3 principal_values(const Mat3& A) {
  return Eigen::SelfAdjointEigenSolver<Mat3>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

std::string values_text(const Vec3& v) {
  return fmt::format("principal values {:.6g}, {:.6g}, {:.6g} kg m2", v[0], v[1], v[2]);
}

/// The largest principal inertia of a body is at most the sum of the others, with equality for a
/// flat body.
bool violates_triangle_inequality(const Vec3& ascending) {
  return ascending[2] > (ascending[0] + ascending[1]) * (1.0 + tolerance::inertia);
}

std::string matrix_problem(const Mat3& I) {
  if (!I.allFinite()) return "an inertia that is not finite";
  const double asymmetry = (I - I.transpose()).cwiseAbs().maxCoeff();
  if (asymmetry > tolerance::inertia * I.cwiseAbs().maxCoeff())
    return fmt::format("an inertia that is not symmetric (by {:.3g} kg m2)", asymmetry);
  const Vec3 values = principal_values(I);
  if (values[0] <= 0.0) return "an inertia that is not positive: " + values_text(values);
  return "";
}

std::string cone_problem(const Cone& cone, std::size_t k) {
  if (!cone.axis_B.allFinite() || !(cone.axis_B.norm() > 0.0))
    return fmt::format("cone {}: an axis of length {}", k + 1, cone.axis_B.norm());
  if (!std::isfinite(cone.axial_inertia) || cone.axial_inertia <= 0.0)
    return fmt::format("cone {}: an axial inertia of {} kg m2", k + 1, cone.axial_inertia);
  return "";
}

Mat3 carrier_inertia(const Mat3& I, const std::vector<Cone>& cones) {
  Mat3 It = 0.5 * (I + I.transpose());
  for (const Cone& c : cones) {
    const Vec3 s = c.axis_B.normalized();
    It -= c.axial_inertia * s * s.transpose();
  }
  return It;
}

/// Inertia of the body without the cones, each taken as flat as possible: a cone has at least half
/// its axial inertia about every transverse axis.
Mat3 body_inertia_share(const Mat3& It, const std::vector<Cone>& cones) {
  Mat3 rest = It;
  for (const Cone& c : cones) {
    const Vec3 s = c.axis_B.normalized();
    rest -= 0.5 * c.axial_inertia * (Mat3::Identity() - s * s.transpose());
  }
  return rest;
}

std::string body_problem(const Mat3& I, const std::vector<Cone>& cones) {
  const Vec3 whole = principal_values(I);
  if (violates_triangle_inequality(whole))
    return "an inertia that violates the triangle inequality: " + values_text(whole);
  const Vec3 share = principal_values(body_inertia_share(carrier_inertia(I, cones), cones));
  if (share[0] < -tolerance::inertia * whole[2])
    return "cones with more inertia than the whole permits: without them " + values_text(share);
  if (violates_triangle_inequality(share))
    return "cones whose removal leaves an inertia that violates the triangle inequality: " +
           values_text(share);
  return "";
}

}  // namespace

std::string inertia_problem(const Mat3& inertia_B, const std::vector<Cone>& cones,
                            InertiaCheck check) {
  if (std::string why = matrix_problem(inertia_B); !why.empty()) return why;
  for (std::size_t k = 0; k < cones.size(); ++k)
    if (std::string why = cone_problem(cones[k], k); !why.empty()) return why;
  const Vec3 carrier = principal_values(carrier_inertia(inertia_B, cones));
  if (carrier[0] <= tolerance::inertia * carrier[2])
    return "cones with more inertia than the whole permits: without their axial inertias " +
           values_text(carrier);
  return check == InertiaCheck::on ? body_problem(inertia_B, cones) : "";
}

Gyrostat make_gyrostat(const Mat3& inertia_B, std::vector<Cone> cones, InertiaCheck check) {
  if (const std::string why = inertia_problem(inertia_B, cones, check); !why.empty())
    throw InputError(why);
  Gyrostat g;
  g.inertia_B = 0.5 * (inertia_B + inertia_B.transpose());
  g.carrier_B = carrier_inertia(inertia_B, cones);
  g.cones = std::move(cones);
  for (Cone& c : g.cones) c.axis_B.normalize();
  g.carrier_inverse_B = g.carrier_B.inverse();
  principal_frame(g.carrier_B, g.principal, g.principal_axes_B);
  equalize_principal_values(g.principal);
  g.principal_rates = g.principal.cwiseInverse();
  return g;
}

RotationState make_state(const Gyrostat& g, const Mat3& R_WB, const Vec3& w_B,
                         std::span<const double> spins, std::span<const double> angles) {
  RotationState s;
  s.q_WB = Eigen::Quaterniond(R_WB).normalized();
  rotation::renormalise(s.q_WB);
  Vec3 momentum_B = g.carrier_B * w_B;
  for (std::size_t k = 0; k < g.cones.size(); ++k) {
    const Cone& cone = g.cones[k];
    s.cone_angles.push_back(angles[k]);
    s.cone_momenta.push_back(cone.axial_inertia * (spins[k] + cone.axis_B.dot(w_B)));
    momentum_B += s.cone_momenta[k] * cone.axis_B;
  }
  s.momentum_W = s.q_WB * momentum_B;
  return s;
}

}  // namespace tdbd::dynamics
