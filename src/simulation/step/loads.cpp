#include "simulation/step/loads.hpp"

namespace tdbd::simulation {
namespace {

void add(const bit::Bit& bit, const Pose& X_WB, const CutOfPart& c, const PartLoad& p,
         BitLoads& loads) {
  loads.force_W += p.force_W;
  loads.torque_W += (p.point_W - X_WB.p).cross(p.force_W);
  loads.power += p.power;
  if (c.cone < 0) return;
  const Pose X_WK = X_WB * bit.cones[at(c.cone)].X_BK;
  loads.cone_torques[at(c.cone)] += X_WK.R.col(2).dot((p.point_W - X_WK.p).cross(p.force_W));
}

}  // namespace

void sum_loads(const ForcePlan& plan, const bit::Bit& bit, const Pose& X_WB,
               const BitVelocity& motion, double dt, std::vector<CutOfPart>& cuts,
               BitLoads& loads) {
  loads.parts.assign(bit.parts.size(), {});
  loads.cone_torques.assign(bit.cones.size(), 0.0);
  loads.force_W = loads.torque_W = Vec3::Zero();
  loads.power = 0.0;
  for (CutOfPart& c : cuts) {
    set_velocity(bit, X_WB, motion, dt, c);
    const forces::PartForce f = forces::force(law_of(plan, c.cut.kind), c.cut);
    PartLoad& p = loads.parts[at(c.part)];
    p = {f.force, f.point, f.normal, f.tangential, -f.force.dot(c.cut.velocity)};
    add(bit, X_WB, c, p, loads);
  }
}

}  // namespace tdbd::simulation
