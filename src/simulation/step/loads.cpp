#include "simulation/step/loads.hpp"

namespace tdbd::simulation {
namespace {

void add_load(const bit::Bit& bit, const Pose& X_WB, int cone, const PartLoad& p, BitLoads& loads) {
  loads.force_W += p.force_W;
  loads.torque_W += (p.point_W - X_WB.p).cross(p.force_W);
  loads.power += p.power;
  if (cone < 0) return;
  const Pose X_WK = X_WB * bit.cones[at(cone)].X_BK;
  loads.cone_torques[at(cone)] += X_WK.R.col(2).dot((p.point_W - X_WK.p).cross(p.force_W));
}

}  // namespace

void sum_loads(const ForcePlan& plan, const bit::Bit& bit, const Pose& X_WB,
               const BitVelocity& motion, double dt, const std::vector<CutOfPart>& cuts,
               BitLoads& loads) {
  loads.parts.assign(bit.parts.size(), {});
  loads.cone_torques.assign(bit.cones.size(), 0.0);
  loads.force_W = loads.torque_W = Vec3::Zero();
  loads.power = 0.0;
  for (const CutOfPart& c : cuts) {
    const forces::PartCut moving = cut_at(bit, X_WB, motion, dt, c);
    const forces::PartForce f = forces::force(law_of(plan, moving.kind), moving);
    PartLoad& p = loads.parts[at(c.part)];
    p = {f.force, f.point, f.normal, f.tangential, -f.force.dot(moving.velocity)};
    add_load(bit, X_WB, c.cone, p, loads);
  }
}

}  // namespace tdbd::simulation
