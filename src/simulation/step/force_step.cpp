#include "simulation/step/force_step.hpp"

#include "core/error.hpp"
#include "dynamics/drilling/divergence.hpp"
#include "simulation/step/cone_balance.hpp"

namespace tdbd::simulation {
namespace {

/// The velocity of the screw motion that made the step, at its end.
BitVelocity screw_velocity(const MeasuredStep& moved, const std::vector<ConeState>& cones) {
  const rotation::Twist twist = rotation::twist_from(moved.X_WB0, moved.X_WB1, moved.dt);
  const Mat3& R_WB = moved.X_WB1.R;
  return {moved.X_WB1.p, R_WB * twist.linear_B, R_WB * twist.angular_B, speeds_of(cones)};
}

/// A diverging step leaves the motion as it was before it.
void demand_convergence(const Case& c, Simulation& s) {
  const std::string what = dynamics::divergence(c.drilling.system, *s.drive);
  if (what.empty()) return;
  *s.drive = s.drive_before;
  s.place = place_of(c.drilling.system, s.drive->state);
  throw RunError("the motion diverges: " + what);
}

/// Asks the laws where forces move the bit, at the momenta that the last forces predict, and gives
/// it their impulses: to the cones' own spins all that of the step, to the rest half of it.
void drive_on(const Case& c, const MeasuredStep& moved, Simulation& s) {
  const dynamics::DrillingSystem& system = c.drilling.system;
  const dynamics::DrillingState& ahead = dynamics::predicted(system, moved.dt, *s.drive);
  s.velocity = velocity_of(system, ahead);
  balance_cones(c.forces, c.bit, system, ahead, moved.X_WB1, moved.dt, s.velocity, s.cuts);
  sum_loads(c.forces, c.bit, moved.X_WB1, s.velocity, moved.dt, s.cuts, s.loads);
  dynamics::Wrench wrench = wrench_of(system, s.loads, moved.X_WB1);
  for (double& torque : wrench.cones) torque *= 2.0;
  dynamics::close_step(system, moved.dt, wrench, *s.drive);
  for (double& torque : s.drive->wrench.cones) torque = 0.0;
  demand_convergence(c, s);
}

}  // namespace

void ask_forces(const Case& c, const MeasuredStep& moved, Simulation& s) {
  gather_cuts(c.forces, moved, s.measures, s.cuts);
  if (s.drive) {
    drive_on(c, moved, s);
  } else {
    s.velocity = screw_velocity(moved, s.cones);
    sum_loads(c.forces, c.bit, moved.X_WB1, s.velocity, moved.dt, s.cuts, s.loads);
  }
  s.energy_by_part.resize(s.loads.parts.size(), 0.0);
  for (std::size_t i = 0; i < s.loads.parts.size(); ++i)
    s.energy_by_part[i] += s.loads.parts[i].power * moved.dt;
  const double since = c.time.step * static_cast<double>(s.steps_done + 1 - c.time.first);
  if (since <= c.output.means_from) return;
  const LoadedStep loaded{s.loads, s.velocity, moved.X_WB1, s.cut.removed_by_part, moved.dt};
  add(loaded, s.load_statistics);
  add(loaded, s.trace);
}

}  // namespace tdbd::simulation
