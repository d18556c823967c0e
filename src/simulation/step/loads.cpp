#include "simulation/step/loads.hpp"

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

}  // namespace tdbd::simulation
