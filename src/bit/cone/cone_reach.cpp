#include "bit/cone/cone_reach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bit/cone/cone_frame.hpp"
#include "bit/cone/cone_parts.hpp"
#include "core/angles.hpp"
#include "core/error.hpp"

namespace tdbd::bit {
namespace {

Vec3 on_circle(const Pose& X_BK, const ShellPoint& p, double angle) {
  return X_BK * Vec3(p.r * std::cos(angle), p.r * std::sin(angle), -p.s);
}

/// Half the derivative of the squared distance from the bit's axis.
double slope(const Pose& X_BK, const ShellPoint& p, double angle) {
  const Vec3 d = X_BK.R * Vec3(-p.r * std::sin(angle), p.r * std::cos(angle), 0.0);
  return on_circle(X_BK, p, angle).head<2>().dot(d.head<2>());
}

/// The angle at which the slope changes from positive (at lo) to negative (at hi).
double top_between(const Pose& X_BK, const ShellPoint& p, double lo, double hi) {
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (lo + hi);
    (slope(X_BK, p, middle) > 0.0 ? lo : hi) = middle;
  }
  return lo;
}

double gage_reach(const ConeLayout& cone) {
  double radius = 0.0;
  for (const ToothRow& row : cone.rows)
    if (row.place == RowPlace::gage)
      radius = std::max(radius, reach_of(cone_pose(cone, 0.0), row_meridian(cone, row)).radius);
  return radius;
}

}  // namespace

ConeReach reach_of(const Pose& X_BK, const ShellPoint& p) {
  constexpr int samples = 72;  // a trigonometric polynomial of degree 2 has at most two maxima
  ConeReach best;
  int at = 0;
  for (int k = 0; k < samples; ++k) {
    const double radius = on_circle(X_BK, p, full_turn * k / samples).head<2>().norm();
    if (radius > best.radius) {
      best.radius = radius;
      at = k;
    }
  }
  best.angle = top_between(X_BK, p, full_turn * (at - 1) / samples, full_turn * (at + 1) / samples);
  best.radius = on_circle(X_BK, p, best.angle).head<2>().norm();
  const Vec3 z_B = X_BK.R.col(2);
  best.depth = X_BK.p.z() - p.s * z_B.z() + p.r * z_B.head<2>().norm();
  return best;
}

ConeReach reach_of(const Pose& X_BK, const Meridian& m) {
  ConeReach all = reach_of(X_BK, m.front());
  for (const ShellPoint& p : m) {
    const ConeReach one = reach_of(X_BK, p);
    const double depth = std::max(all.depth, one.depth);
    if (one.radius > all.radius) all = one;
    all.depth = depth;
  }
  return all;
}

double apex_for_gage(ConeLayout cone, double gage_radius) {
  constexpr int halvings = 80;
  const auto excess = [&](double apex) {
    cone.apex = apex;
    return gage_reach(cone) - gage_radius;
  };
  double inner = gage_radius, outer = -gage_radius;
  if (excess(inner) > 0.0 || excess(outer) < 0.0)
    throw InputError(fmt::format(
        "no place along the journal at which the gage row reaches {:.3f} mm", 1e3 * gage_radius));
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (inner + outer);
    (excess(middle) > 0.0 ? outer : inner) = middle;
  }
  return inner;
}

double largest_turned_radius(const Bit& bit) {
  double radius = largest_radius(bit.parts);
  for (const Part& part : bit.parts) {
    if (part.cone < 0 || part.cutting == Cutting::never) continue;
    const Pose& X_BK = bit.cones[static_cast<std::size_t>(part.cone)].X_BK;
    for (const Vec3& x_P : part.mesh_P.positions) {
      const Vec3 x_K = inverse(X_BK) * (part.X_BP * x_P);
      const ShellPoint place{-x_K.z(), x_K.head<2>().norm()};
      radius = std::max(radius, reach_of(X_BK, place).radius);
    }
  }
  return radius;
}

}  // namespace tdbd::bit
