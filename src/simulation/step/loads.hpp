#pragma once

#include <vector>

#include "simulation/step/cuts.hpp"

namespace tdbd::simulation {

/// Force of the rock on one part. Frame W.
struct PartLoad {
  Vec3 force_W = Vec3::Zero();  ///< N, on the bit
  Vec3 point_W = Vec3::Zero();  ///< m; for several contacts of a part, the mean weighted by force
  double normal = 0.0;          ///< N, Fn of the law
  double tangential = 0.0;      ///< N, Ft
  double power = 0.0;           ///< W, dissipated in the rock: -F . v
};

/// Forces of the rock on the bit in a step.
struct BitLoads {
  std::vector<PartLoad> parts;       ///< one per part of the bit
  Vec3 force_W = Vec3::Zero();       ///< N
  Vec3 torque_W = Vec3::Zero();      ///< N m, about the origin of the bit
  std::vector<double> cone_torques;  ///< N m, about the Z axis of each cone, of the forces on it
  double power = 0.0;                ///< W
};

/// Evaluates the law of the part that made this cut, for this motion of the bit.
PartLoad load_of(const ForcePlan& plan, const bit::Bit& bit, const Pose& X_WB,
                 const BitVelocity& motion, double dt, const CutOfPart& cut);

/// Torque of a load about the Z axis of a cone, N m.
double torque_about_cone(const bit::Bit& bit, const Pose& X_WB, int cone, const PartLoad& load);

/// Sets all loads to zero.
void clear(const bit::Bit& bit, BitLoads& loads);

/// Adds the load of the part that made this cut.
void add(const PartLoad& load, const bit::Bit& bit, const Pose& X_WB, const CutOfPart& cut,
         BitLoads& loads);

/// Evaluates the laws of all parts for this motion of the bit and sums the loads, simulation (4). A
/// pure function except that it reuses the memory of `loads`.
void sum_loads(const ForcePlan& plan, const bit::Bit& bit, const Pose& X_WB,
               const BitVelocity& motion, double dt, const std::vector<CutOfPart>& cuts,
               BitLoads& loads);

}  // namespace tdbd::simulation
