#include <fmt/format.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/error.hpp"
#include "reference/dynamics/closed_forms.hpp"
#include "reference/dynamics/quiet_gsl.hpp"

namespace tdbd::reference {
namespace {

/// The body in the right-handed axes (a, b, c): b is that of the middle inertia, c the one about
/// which the momentum circles. W = (cn, sn, dn) by component, times amplitudes.
struct Elliptic {
  Mat3 axes_B = Mat3::Identity();  ///< a, b, c as columns
  Vec3 inertia = Vec3::Ones();     ///< kg m2, about a, b, c
  Vec3 amplitude = Vec3::Zero();   ///< rad/s, with signs
  double frequency = 0.0;          ///< rad/s, of the argument
  double modulus_squared = 0.0;    ///< k^2
  double argument = 0.0;           ///< at t = 0
  double momentum = 0.0;           ///< N m s, magnitude
};

/// Indices of the principal axes in ascending order of inertia.
std::array<int, 3> ascending(const Vec3& principal) {
  std::array<int, 3> order{0, 1, 2};
  std::ranges::sort(order, [&](int i, int j) { return principal[i] < principal[j]; });
  return order;
}

/// Columns a, b, c. c is the axis of the smallest or the largest inertia, the one that the momentum
/// circles; the largest if M^2 > 2 E I_middle.
Mat3 elliptic_axes(const Vec3& principal, const Vec3& w) {
  const auto [low, middle, high] = ascending(principal);
  const double side = principal[high] * w[high] * w[high] * (principal[high] - principal[middle]) -
                      principal[low] * w[low] * w[low] * (principal[middle] - principal[low]);
  const int a = side > 0.0 ? low : high, c = side > 0.0 ? high : low;
  Mat3 axes = Mat3::Zero();
  axes(a, 0) = 1.0;
  axes(c, 2) = 1.0;
  axes.col(1) = Vec3(axes.col(2)).cross(Vec3(axes.col(0)));
  return axes;
}

Elliptic elliptic(const Vec3& principal, const Vec3& w_B) {
  Elliptic e;
  e.axes_B = elliptic_axes(principal, w_B);
  e.inertia = e.axes_B.cwiseAbs().transpose() * principal;
  const Vec3 w = e.axes_B.transpose() * w_B;
  const Vec3 momentum = e.inertia.cwiseProduct(w);
  const double A = e.inertia[0], B = e.inertia[1], C = e.inertia[2];
  // 2 E C - M^2 and M^2 - 2 E A, without cancellation.
  const double below = A * w[0] * w[0] * (C - A) + B * w[1] * w[1] * (C - B);
  const double above = B * w[1] * w[1] * (B - A) + C * w[2] * w[2] * (C - A);
  const double sign_a = std::copysign(1.0, w[0]), sign_c = std::copysign(1.0, w[2]);
  const double sign_b = C > B ? sign_a * sign_c : -sign_a * sign_c;
  e.amplitude = {sign_a * std::sqrt(below / (A * (C - A))),
                 sign_b * std::sqrt(below / (B * (C - B))),
                 sign_c * std::sqrt(above / (C * (C - A)))};
  e.frequency = std::sqrt((C - B) * above / (A * B * C));
  e.modulus_squared = std::min(1.0, (B - A) * below / ((C - B) * above));
  e.momentum = momentum.norm();
  e.argument = gsl_sf_ellint_F(std::atan2(w[1] / e.amplitude[1], w[0] / e.amplitude[0]),
                               std::sqrt(e.modulus_squared), GSL_PREC_DOUBLE);
  return e;
}

/// The angular velocity in the axes a, b, c.
Vec3 angular_velocity(const Elliptic& e, double t) {
  double sn = 0.0, cn = 0.0, dn = 0.0;
  gsl_sf_elljac_e(e.argument + e.frequency * t, e.modulus_squared, &sn, &cn, &dn);
  return e.amplitude.cwiseProduct(Vec3(cn, sn, dn));
}

/// Rate at which the axis c rotates about the momentum, rad/s.
double round_rate(double t, void* context) {
  const auto& e = *static_cast<const Elliptic*>(context);
  const Vec3 w = angular_velocity(e, t);
  const Vec3 P = e.inertia.cwiseProduct(w);
  return e.momentum * (P[0] * w[0] + P[1] * w[1]) / (P[0] * P[0] + P[1] * P[1]);
}

/// The angle by which c has rotated about the momentum at time t, rad.
double round_angle(Elliptic e, double t) {
  constexpr std::size_t intervals = 1000;
  // relative to 1 + angle; GSL's estimate is pessimistic
  constexpr double wanted = 1e-13, accepted = 1e-11;
  const QuietGsl quiet;
  const std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)> workspace(
      gsl_integration_workspace_alloc(intervals), gsl_integration_workspace_free);
  gsl_function rate{round_rate, &e};
  double angle = 0.0, error = 0.0;
  gsl_integration_qag(&rate, 0.0, t, wanted, wanted, intervals, GSL_INTEG_GAUSS61, workspace.get(),
                      &angle, &error);
  if (!(error <= accepted * (1.0 + std::abs(angle))))
    throw RunError(fmt::format("free body: the angle {} rad is known to {} only", angle, error));
  return angle;
}

/// Rotation from the axes a, b, c to a frame with its third axis along the momentum and its first
/// perpendicular to c.
Mat3 to_momentum(const Elliptic& e, const Vec3& w) {
  const Vec3 p = e.inertia.cwiseProduct(w).normalized();
  const Vec3 node = Vec3::UnitZ().cross(p).normalized();
  Mat3 frame;
  frame << node.transpose(), p.cross(node).transpose(), p.transpose();
  return frame;
}

}  // namespace

Turning free_asymmetric_body(const Vec3& principal, const Turning& start, double t) {
  const bool steady = (start.w_B.array() == 0.0).count() >= 2;
  if (steady) {
    const Eigen::AngleAxisd turned(start.w_B.norm() * t, start.w_B.normalized());
    return {start.R_WB * turned.toRotationMatrix(), start.w_B};
  }
  const Elliptic e = elliptic(principal, start.w_B);
  const Vec3 w = angular_velocity(e, t);
  const Mat3 round(Eigen::AngleAxisd(round_angle(e, t), Vec3::UnitZ()));
  const Mat3 turned =
      to_momentum(e, angular_velocity(e, 0.0)).transpose() * round * to_momentum(e, w);
  return {start.R_WB * e.axes_B * turned * e.axes_B.transpose(), e.axes_B * w};
}

}  // namespace tdbd::reference
