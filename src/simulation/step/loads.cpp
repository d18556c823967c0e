#include "simulation/step/loads.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::simulation {

PartLoad load_of(const ForcePlan& plan, const bit::Bit& bit, const Pose& X_WB,
                 const BitVelocity& motion, double dt, const CutOfPart& c) {
  const Vec3 v_W = velocity_at(bit, X_WB, motion, c.cone, c.cut.point);
  const forces::PartCut cut = cut_at_velocity(v_W, dt, c);
  const forces::PartForce f = forces::force(law_of(plan, c), cut);
  return {f.force, f.point, f.normal, f.tangential, -f.force.dot(v_W)};
}

double torque_about_cone(const bit::Bit& bit, const Pose& X_WB, int cone, const PartLoad& load) {
  const Pose X_WK = X_WB * bit.cones[at(cone)].X_BK;
  return X_WK.R.col(2).dot((load.point_W - X_WK.p).cross(load.force_W));
}

void clear(const bit::Bit& bit, BitLoads& loads) {
  loads.parts.assign(bit.parts.size(), {});
  loads.cone_torques.assign(bit.cones.size(), 0.0);
  loads.force_W = loads.torque_W = Vec3::Zero();
  loads.power = 0.0;
}

void add(const PartLoad& p, const bit::Bit& bit, const Pose& X_WB, const CutOfPart& c,
         BitLoads& loads) {
  PartLoad& part = loads.parts[at(c.part)];
  const double share = p.force_W.norm(), total = part.force_W.norm() + share;
  if (total > 0.0) part.point_W += share / total * (p.point_W - part.point_W);
  part.force_W += p.force_W;
  part.normal += p.normal;
  part.tangential += p.tangential;
  part.power += p.power;
  loads.force_W += p.force_W;
  loads.torque_W += (p.point_W - X_WB.p).cross(p.force_W);
  loads.power += p.power;
  if (c.cone >= 0) loads.cone_torques[at(c.cone)] += torque_about_cone(bit, X_WB, c.cone, p);
}

void sum_loads(const ForcePlan& plan, const bit::Bit& bit, const Pose& X_WB,
               const BitVelocity& motion, double dt, const std::vector<CutOfPart>& cuts,
               BitLoads& loads) {
  clear(bit, loads);
  for (const CutOfPart& c : cuts) add(load_of(plan, bit, X_WB, motion, dt, c), bit, X_WB, c, loads);
}

namespace {

/// Slope of a law by differences of a millionth of the speed: well above rounding, and small
/// compared with the curvature.
Mat3 slope(const forces::Law& law, const CutOfPart& cut, const Vec3& v, double dt, const Vec3& F) {
  constexpr double over_speed = 1e-6;
  const double dv = over_speed * v.norm();
  Mat3 D;
  for (int j = 0; j < 3; ++j) {
    const forces::PartCut moved = cut_at_velocity(v + dv * Vec3::Unit(j), dt, cut);
    D.col(j) = (F - forces::force(law, moved).force) / dv;
  }
  return D;
}

}  // namespace

Mat3 secant_resistance(const Vec3& v, const Vec3& F) {
  const double v2 = v.squaredNorm(), along = F.dot(v) / v2;
  const Vec3 q = -(F - along * v) / v2;
  return -along * Mat3::Identity() + q * v.transpose() - v * q.transpose();
}

PartDrag drag_of(const ForcePlan& plan, const CutOfPart& cut, const Vec3& v_W, double dt,
                 Resistance which) {
  const Vec3 v = v_W.norm() > smallest_speed ? v_W : Vec3(smallest_speed * cut.cut.normal);
  const forces::Law& law = law_of(plan, cut);
  PartDrag drag;
  drag.force = forces::force(law, cut_at_velocity(v, dt, cut));
  if (which == Resistance::secant) drag.resistance = secant_resistance(v, drag.force.force);
  if (which == Resistance::tangent) drag.resistance = slope(law, cut, v, dt, drag.force.force);
  return drag;
}

namespace {

/// The augmented normal force and its slope with respect to v_n.
struct Normal {
  double p, slope;  // N, N s/m
};

Normal normal_force(const PressedContact& c, double into, double along) {
  const double compliance = c.law.ramp > 0.0 ? c.law.ramp * along / c.law.limit : 0.0;
  const double slope = c.k_n / (1.0 + c.k_n * compliance);
  const double p = (c.p + c.k_n * (into - c.free_speed)) / (1.0 + c.k_n * compliance);
  if (p <= 0.0) return {0.0, 0.0};
  return p < c.law.limit ? Normal{p, slope} : Normal{c.law.limit, 0.0};
}

/// d mu/d speed, s/m.
double friction_slope(const forces::Sliding& s, double speed) {
  return -s.mu * s.weakening / s.weakening_speed * std::exp(-speed / s.weakening_speed);
}

}  // namespace

PartDrag drag_of(const PressedContact& c, const Vec3& v_W) {
  const Vec3& n = c.normal_W;
  const double into = v_W.dot(n);
  const Vec3 slip = v_W - into * n;
  const double along = slip.norm();
  const double at_slip = c.slip.value_or(along);
  const Normal normal = normal_force(c, into, at_slip);
  const double mu = forces::friction_at(c.law.sliding, at_slip), most = mu * normal.p;
  Vec3 t = c.friction_W + c.k_t * slip;
  const double wanted = t.norm();
  const Mat3 across = Mat3::Identity() - n * n.transpose();
  PartDrag drag;
  drag.resistance = normal.slope * n * n.transpose();
  if (wanted <= most) {
    drag.resistance += c.k_t * across;
  } else {
    const Vec3 e = t / wanted;
    t = most * e;
    drag.resistance += most / wanted * c.k_t * (across - e * e.transpose()) +
                       mu * normal.slope * e * n.transpose();
    if (along > 0.0 && !c.slip)
      drag.resistance +=
          normal.p * friction_slope(c.law.sliding, along) / along * e * slip.transpose();
  }
  drag.force.normal = normal.p;
  drag.force.tangential = t.norm();
  drag.force.force = -normal.p * n - t;
  return drag;
}

void update_estimate(PressedContact& c, const Vec3& v_W) {
  const PartDrag now = drag_of(c, v_W);
  c.p = now.force.normal;
  c.friction_W = -now.force.force - c.p * c.normal_W;
}

}  // namespace tdbd::simulation
