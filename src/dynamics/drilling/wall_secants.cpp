#include "dynamics/drilling/wall_secants.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::dynamics {
namespace {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

constexpr double settled = 1e-9;      ///< Newton step in ln g; the next error is its square
constexpr double longest_step = 4.0;  ///< in ln g
constexpr int most_newton_steps = 40;
constexpr double bracket_width = 60.0;  ///< in ln g, below the largest secant
constexpr int most_halvings = 100;
constexpr double least_normal = 1e-15;  ///< of the spring's force; keeps the logarithm finite

double slip_speed(const WallLaw& law) { return std::max(law.slip_speed, coulomb_creep); }

/// ln(tanh(q)/q) and its derivative with respect to ln q, q >= 0.
struct LogTanhc {
  double value = 0.0, slope = 0.0;
};
LogTanhc log_tanhc(double q) {
  constexpr double small = 1e-3, large = 20.0;
  if (q < small) return {-q * q / 3.0, -2.0 / 3.0 * q * q};
  if (q > large) return {-std::log(q), -1.0};
  return {std::log(std::tanh(q) / q), 2.0 * q / std::sinh(2.0 * q) - 1.0};
}

/// Logarithms of the largest secants.
Vec2 largest(const WallLaw& law) {
  return {std::log(law.friction * (law.spring + law.loss) / slip_speed(law)),
          std::log(law.loss / radial_creep)};
}

WallSecants secants_of(const WallLaw& law, const Vec2& x) {
  return {law.friction > 0.0 ? std::exp(x[0]) : 0.0, law.loss > 0.0 ? std::exp(x[1]) : 0.0};
}

Eigen::Matrix3cd resisted_inverse(const WallResponse& r, const WallSecants& g) {
  Eigen::Matrix3cd A = r.gain * Vec3(g.slip, g.slip, g.radial).asDiagonal();
  A.diagonal().array() += 1.0;
  return A.inverse();
}

/// Normal force. `borne` is the force of the loss along the radius, at most `loss`.
double normal_force(const WallLaw& law, double borne) {
  return std::max(law.spring + std::clamp(borne, -law.loss, law.loss), least_normal * law.spring);
}

/// Residuals of the logarithms of both secants at the resulting speeds, and their derivatives with
/// respect to the logarithms.
struct Disagreement {
  Vec2 f = Vec2::Zero();
  Mat2 J = Mat2::Identity();
};

Disagreement disagreement(const WallLaw& law, const WallResponse& r, const Vec2& x) {
  const WallSecants g = secants_of(law, x);
  const Eigen::Matrix3cd inverse = resisted_inverse(r, g);
  const Eigen::Vector3cd m = inverse * r.free;
  const Eigen::Vector3cd by_slip = -g.slip * (inverse * (r.gain.leftCols<2>() * m.head<2>())),
                         by_radial = -g.radial * (inverse * (r.gain.col(2) * m[2]));
  const Vec3 v = m.real();
  const Vec3 dv[2] = {by_slip.real(), by_radial.real()};
  Disagreement d;
  if (law.friction > 0.0) {
    const double slip = v.head<2>().norm(), borne = g.radial * v[2];
    const double normal = normal_force(law, borne);
    const bool is_free = std::abs(borne) < law.loss;  // the bound is inactive
    const LogTanhc t = log_tanhc(slip / slip_speed(law));
    d.f[0] = x[0] - std::log(law.friction * normal / slip_speed(law)) - t.value;
    for (int j = 0; j < 2; ++j) {
      const double slip_slope = slip > 0.0 ? v.head<2>().dot(dv[j].head<2>()) / (slip * slip) : 0.0;
      const double normal_slope = g.radial * dv[j][2] + (j == 1 ? borne : 0.0);
      d.J(0, j) =
          (j == 0 ? 1.0 : 0.0) - t.slope * slip_slope - (is_free ? normal_slope / normal : 0.0);
    }
  }
  if (law.loss > 0.0) {
    const double speed = std::abs(v[2]);
    d.f[1] = x[1] - std::log(law.loss) + std::log(std::max(speed, radial_creep));
    if (speed > radial_creep)
      for (int j = 0; j < 2; ++j) d.J(1, j) += dv[j][2] / v[2];
  }
  return d;
}

/// Secants at the speeds at the start of the flow.
Vec2 first_guess(const WallLaw& law, const Vec3& start) {
  Vec2 x = Vec2::Zero();
  const double radial = 1.0 / std::max(std::abs(start[2]), radial_creep);
  if (law.loss > 0.0) x[1] = std::log(law.loss * radial);
  if (law.friction > 0.0)
    x[0] =
        std::log(law.friction * normal_force(law, law.loss * radial * start[2]) / slip_speed(law)) +
        log_tanhc(start.head<2>().norm() / slip_speed(law)).value;
  return x;
}

bool newton(const WallLaw& law, const WallResponse& r, Vec2& x, int& steps) {
  for (steps = 0; steps < most_newton_steps; ++steps) {
    const Disagreement d = disagreement(law, r, x);
    Vec2 step = d.J.inverse() * d.f;
    if (!step.allFinite()) return false;
    const double length = step.cwiseAbs().maxCoeff();
    x -= step * std::min(1.0, longest_step / length);
    if (length < settled) return true;
  }
  return false;
}

/// Root of a function that is negative at `low` and positive at `high`, by the Illinois variant of
/// false position.
template <class F>
double sign_change(const F& f, double low, double high) {
  double f_low = f(low), f_high = f(high);
  if (f_low >= 0.0) return low;
  if (f_high <= 0.0) return high;
  int stays = 0;
  for (int i = 0; i < most_halvings && high - low > 1e-13 * bracket_width; ++i) {
    const bool halve = i % 3 == 2;
    const double middle =
        halve ? 0.5 * (low + high) : (f_low * high - f_high * low) / (f_low - f_high);
    const double f_middle = f(middle);
    if (f_middle == 0.0) return middle;
    if (f_middle < 0.0) {
      low = middle;
      f_low = f_middle;
      if (stays > 0) f_high *= 0.5;
      stays = 1;
    } else {
      high = middle;
      f_high = f_middle;
      if (stays < 0) f_low *= 0.5;
      stays = -1;
    }
  }
  return 0.5 * (low + high);
}

Vec2 nested_brackets(const WallLaw& law, const WallResponse& r) {
  const Vec2 high = largest(law);
  Vec2 x = Vec2::Zero();
  const auto slip_for = [&](double radial) {
    if (law.friction == 0.0) return 0.0;
    return sign_change(
        [&](double t) {
          return disagreement(law, r, {t, radial}).f[0];
        },
        high[0] - bracket_width, high[0]);
  };
  if (law.loss > 0.0)
    x[1] = sign_change(
        [&](double radial) {
          return disagreement(law, r, {slip_for(radial), radial}).f[1];
        },
        high[1] - bracket_width, high[1]);
  x[0] = slip_for(x[1]);
  return x;
}

}  // namespace

Eigen::Vector3cd contact_speeds(const WallResponse& r, const WallSecants& g) {
  return resisted_inverse(r, g) * r.free;
}

WallSecants find_wall_secants(const WallLaw& law, const WallResponse& r, const Vec3& start,
                              SecantSearch* search) {
  Vec2 x = first_guess(law, start);
  SecantSearch found;
  if (!newton(law, r, x, found.newton_steps)) {
    found.bracketed = true;
    x = nested_brackets(law, r);
  }
  if (search != nullptr) *search = found;
  return secants_of(law, x);
}

}  // namespace tdbd::dynamics
