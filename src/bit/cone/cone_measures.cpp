#include "bit/cone/cone_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bit/cone/cone_bit.hpp"
#include "core/error.hpp"
#include "core/types.hpp"

namespace tdbd::bit {

ConeMass cone_mass(const Bit& bit, int cone) {
  const Pose X_KB = inverse(bit.cones[static_cast<std::size_t>(cone)].X_BK);
  ConeMass c;
  for (const Part& part : bit.parts)
    if (part.cone == cone && part.density > 0.0)
      c.body_K = combined(
          c.body_K, transformed(mass_properties(part.mesh_P, part.density), X_KB * part.X_BP));
  const Mat3& i = c.body_K.inertia;
  c.centre_off_axis = c.body_K.centre.head<2>().norm();
  c.axial_inertia = i(2, 2) + c.body_K.mass * c.centre_off_axis * c.centre_off_axis;
  const double difference = std::hypot(i(0, 0) - i(1, 1), 2.0 * i(0, 1));
  c.asymmetry = c.axial_inertia > 0.0 ? difference / c.axial_inertia : 0.0;
  return c;
}

Vec3 deepest_B(const Cone& cone, double radius, double z_K) {
  const Vec3 z_B = cone.X_BK.R.col(2);
  const Vec3 down_B = (Vec3::UnitZ() - z_B.z() * z_B).normalized();
  return cone.X_BK * Vec3(0.0, 0.0, z_K) + radius * down_B;
}

RowMeasures row_measures(const Cone& cone, const ToothRow& row) {
  constexpr double on_axis = 1e-9;  // m
  const Vec3 tip_K = tooth_pose(cone.layout, row, 0.0) * Vec3(0.0, 0.0, row.shape.protrusion);
  const double radius = tip_K.x();
  const Vec3 lowest_B = deepest_B(cone, radius, tip_K.z());
  const double bit_radius = lowest_B.head<2>().norm();
  return {radius, bit_radius, -lowest_B.z(),
          reach_of(cone.X_BK, row_meridian(cone.layout, row)).radius,
          radius > on_axis ? bit_radius / radius : 0.0};
}

SlipBalance slip_balance(const Pose& X_BK, const rotation::Twist& bit,
                         const std::vector<ConeContact>& contacts) {
  const Vec3 s_B = X_BK.R.col(2);
  SlipBalance sum;
  for (const ConeContact& c : contacts) {
    const Vec3 r_B = c.x_B - X_BK.p;
    sum.moment += c.weight * s_B.dot(r_B.cross(rotation::velocity_B(bit, c.x_B)));
    sum.inertia += c.weight * s_B.cross(r_B).squaredNorm();
  }
  return sum;
}

Vec3 tooth_tip_P(const Part& tooth) {
  double height = 0.0;
  for (const Vec3& x_P : tooth.mesh_P.positions) height = std::max(height, x_P.z());
  return {0.0, 0.0, height};
}

double rolling_ratio_of_gage_row(const Cone& cone) {
  if (cone.layout.rows.empty()) return cone.rolling_ratio;
  RowMeasures outermost;
  bool found_gage = false;
  for (const ToothRow& row : cone.layout.rows) {
    const bool at_gage = row.place == RowPlace::gage;
    const RowMeasures m = row_measures(cone, row);
    if (at_gage < found_gage) continue;
    if (at_gage > found_gage || m.bit_radius > outermost.bit_radius) outermost = m;
    found_gage = found_gage || at_gage;
  }
  return outermost.rolling_ratio;
}

double rolling_ratio_of_parts(const Cone& cone, int index, const std::vector<Part>& parts) {
  const auto turns = [&](const Part& p) { return p.cone == index && p.cutting == Cutting::cuts; };
  const bool has_teeth = std::ranges::any_of(
      parts, [&](const Part& p) { return turns(p) && p.kind == PartKind::tooth; });
  double farthest = 0.0, ratio = 0.0;
  for (const Part& part : parts) {
    if (!turns(part) || (has_teeth && part.kind != PartKind::tooth)) continue;
    double radius = 0.0, z_K = 0.0;
    for (const Vec3& x_P : part.mesh_P.positions) {
      const Vec3 x_K = inverse(cone.X_BK) * (part.X_BP * x_P);
      if (x_K.head<2>().norm() <= radius) continue;
      radius = x_K.head<2>().norm();
      z_K = x_K.z();
    }
    const double bit_radius = deepest_B(cone, radius, z_K).head<2>().norm();
    if (radius == 0.0 || bit_radius <= farthest) continue;
    farthest = bit_radius;
    ratio = bit_radius / radius;
  }
  return ratio;
}

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

namespace {

constexpr double standard_gravity = 9.80665;  ///< m/s2

double about_bit_axis(const MassProperties& m) {
  return m.inertia(2, 2) + m.mass * m.centre.head<2>().squaredNorm();
}

double over(double value, double whole) { return whole > 0.0 ? value / whole : 0.0; }

}  // namespace

ConeAssumptions cone_assumptions(const Bit& bit, int cone, double bit_speed, double cone_ratio) {
  const Pose& X_BK = bit.cones[static_cast<std::size_t>(cone)].X_BK;
  const ConeMass c = cone_mass(bit, cone);
  const MassProperties whole = mass_properties(bit);
  const double mass = c.body_K.mass, e = c.centre_off_axis;
  const Vec3 s_B = X_BK.R.col(2), centre_B = X_BK * Vec3(0.0, 0.0, c.body_K.centre.z());
  const double cosine = s_B.z(), sine = s_B.head<2>().norm();
  const Vec3 flat_B(centre_B.x(), centre_B.y(), 0.0);
  const double arm = (flat_B - s_B.dot(flat_B) * s_B).norm();
  const double tilt = std::hypot(c.body_K.inertia(0, 2), c.body_K.inertia(1, 2));
  const double once = 2.0 * tilt * std::abs(sine * cosine) + 2.0 * mass * e * arm;
  const double twice = 0.5 * (c.asymmetry * c.axial_inertia + mass * e * e) * sine * sine;
  ConeAssumptions a;
  a.cone_speed = bit_speed * cone_ratio;
  a.unbalance_force = mass * e * a.cone_speed * a.cone_speed;
  a.unbalance_share = over(a.unbalance_force, whole.mass * standard_gravity);
  a.gravity_torque = mass * standard_gravity * e;
  a.modulation_once = over(once, about_bit_axis(whole));
  a.modulation_twice = over(twice, about_bit_axis(whole));
  a.frequency = std::abs(a.cone_speed) / full_turn;
  a.torque_error = bit_speed * bit_speed * (0.5 * once + twice);
  a.torque_share = over(a.torque_error, c.axial_inertia * a.cone_speed * a.cone_speed);
  return a;
}

}  // namespace tdbd::bit
