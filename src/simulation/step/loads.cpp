#include "simulation/step/loads.hpp"

namespace tdbd::simulation {

PartLoad load_of(const ForcePlan& plan, const bit::Bit& bit, const Pose& X_WB,
                 const BitVelocity& motion, double dt, const CutOfPart& c) {
  const forces::PartCut cut = cut_at(bit, X_WB, motion, dt, c);
  const forces::PartForce f = forces::force(law_of(plan, cut.kind), cut);
  return {f.force, f.point, f.normal, f.tangential, -f.force.dot(cut.velocity)};
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
  loads.parts[at(c.part)] = p;
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
