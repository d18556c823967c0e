#pragma once

#include <vector>

#include "simulation/step/cuts.hpp"

namespace tdbd::simulation {

/// The rock's force on one part. Frame W.
struct PartLoad {
  Vec3 force_W = Vec3::Zero();  ///< N, on the bit
  Vec3 point_W = Vec3::Zero();  ///< m; of two contacts of one part their mean, by force
  double normal = 0.0;          ///< N, Fn of its law
  double tangential = 0.0;      ///< N, Ft
  double power = 0.0;           ///< W, spent on the rock: -F . v
};

/// The rock's forces on the bit in a step.
struct BitLoads {
  std::vector<PartLoad> parts;       ///< per part of the bit
  Vec3 force_W = Vec3::Zero();       ///< N
  Vec3 torque_W = Vec3::Zero();      ///< N m, about the bit's origin
  std::vector<double> cone_torques;  ///< N m, about the cones' Z, of the forces on each cone
  double power = 0.0;                ///< W
};

/// Evaluates the law of a part that made this cut, at this motion of the bit.
PartLoad load_of(const ForcePlan& plan, const bit::Bit& bit, const Pose& X_WB,
                 const BitVelocity& motion, double dt, const CutOfPart& cut);

/// Torque of a load about a cone's Z, N m.
double torque_about_cone(const bit::Bit& bit, const Pose& X_WB, int cone, const PartLoad& load);

/// No load on any part.
void clear(const bit::Bit& bit, BitLoads& loads);

/// Adds the load of the part that made this cut.
void add(const PartLoad& load, const bit::Bit& bit, const Pose& X_WB, const CutOfPart& cut,
         BitLoads& loads);

/// Evaluates every part's law at this motion of the bit and sums, simulation (4). A pure function
/// of all but `loads`, whose room is used again.
void sum_loads(const ForcePlan& plan, const bit::Bit& bit, const Pose& X_WB,
               const BitVelocity& motion, double dt, const std::vector<CutOfPart>& cuts,
               BitLoads& loads);

}  // namespace tdbd::simulation
