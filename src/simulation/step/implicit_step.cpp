#include "simulation/step/implicit_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rotation/screw.hpp"

namespace tdbd::simulation {
namespace {

/// Above this steepness an explicit impulse overshoots. Bits that drill on faces are well below it.
constexpr double steepness_limit = 1.0;

/// Converts velocities u to the motion of the bit relative to the rock.
void take_velocity(const ResistedMotion& m, const Eigen::VectorXd& u, BitVelocity& v) {
  const auto cones = static_cast<int>(m.bit.cones.size());
  v.p_WB = m.X_WB.p;
  v.w_W = u.segment<3>(3);
  v.v_W = Vec3(u.head<3>()) + v.w_W.cross(v.p_WB - m.centre_W);
  if (u.size() > 6 + cones) v.v_W.z() -= u[6 + cones];
  v.cone_speeds.resize(at(cones));
  for (int k = 0; k < cones; ++k) v.cone_speeds[at(k)] = u[6 + k];
}

/// Inverse masses of bit and rock, 1/kg.
double inverse_mass(const dynamics::DrillingSystem& s) {
  return 1.0 / s.mass + (s.rock.mass > 0.0 ? 1.0 / s.rock.mass : 0.0);
}

/// Bound of the derivative of a pressing surface's force with respect to velocity, N s/m: the
/// normal force divided by its ramp, or without a ramp by the change of v_n at which it jumps; plus
/// the change of direction of friction.
double slope_bound(const forces::Pressing& law, const Vec3& v, const Vec3& normal) {
  const double into = std::abs(v.dot(normal));
  const double along = forces::slip_velocity(v, normal).norm();
  const double until = law.ramp > 0.0 ? law.ramp * along : into;
  return law.limit / std::max(until, smallest_speed) +
         law.sliding.mu * law.limit / std::max(along, smallest_speed);
}

/// Upper bound of the steepness that needs neither probes nor sums: |C_i| of a law of velocity is
/// |F_i|/|v_i|, and the response of a step is at most h M^-1. Infinite if a part of a cone cuts,
/// because the inertia of a cone is so small that its parts always determine its speed.
double steepness_bound(const ResistedMotion& m, const BitVelocity& v, const Mat3& turned_by,
                       double moved_by) {
  double bound = 0.0;
  for (const CutOfPart& cut : m.cuts) {
    if (cut.cone >= 0) return std::numeric_limits<double>::infinity();
    const Vec3 v_W = velocity_at(m.bit, m.X_WB, v, cut.cone, cut.cut.point);
    const auto pressing = pressing_of(m.plan, cut);
    const double slope =
        pressing ? slope_bound(*pressing, v_W, cut.cut.normal)
                 : drag_of(m.plan, cut, v_W, m.dt, Resistance::none).force.force.norm() /
                       std::max(v_W.norm(), smallest_speed);
    const Mat3 arm = rotation::skew(cut.cut.point - m.centre_W);
    bound += m.dt * slope * (moved_by + (arm * turned_by * arm.transpose()).norm());
  }
  return bound;
}

ResistedMotion resisted(const LoadedMotion& m, const ImplicitStepWork& work) {
  const dynamics::DrillingState& now = m.drive.state;
  return {m.c.forces, m.c.bit, m.X_WB,       now.c_W - now.rock_z * Vec3::UnitZ(),
          m.dt,       m.cuts,  work.response};
}

/// Sets `work.implicit.u` to the velocities of the current momenta.
void start_at_momenta(const LoadedMotion& m, dynamics::DrillingWork& drive_work,
                      ImplicitStepWork& work) {
  const dynamics::DrillingSystem& system = m.c.drilling.system;
  dynamics::velocity(system, drive_work.at, m.drive.state, work.responding.velocity);
  dynamics::to_column(system, work.responding.velocity, work.implicit.u);
}

}  // namespace

void add(const ImplicitOutcome& step, ImplicitStatistics& s) {
  if (!step.is_implicit) return;
  ++s.steps;
  if (!step.search.has_converged) ++s.unsettled;
  s.most_rounds = std::max<long>(s.most_rounds, step.search.rounds);
}

ImplicitOutcome solve_implicitly(const LoadedMotion& motion, dynamics::DrillingWork& drive_work,
                                 ImplicitStepWork& work, BitLoads& loads, BitVelocity& velocity) {
  ImplicitOutcome result;
  if (motion.cuts.empty()) return result;
  const dynamics::DrillingSystem& system = motion.c.drilling.system;
  const ResistedMotion m = resisted(motion, work);
  start_at_momenta(motion, drive_work, work);
  take_velocity(m, work.implicit.u, work.last_drift);
  result.steepness =
      steepness_bound(m, work.last_drift, drive_work.at.mobility_W, inverse_mass(system));
  if (result.steepness <= steepness_limit) return result;
  dynamics::find_response(system, motion.dt, motion.drive,
                          dynamics::RemainingKicks::closing_and_opening, drive_work,
                          work.responding, work.response);
  prepare(m, work.implicit);
  if (std::isfinite(result.steepness) && !any_presses(work.implicit))
    result.steepness = steepness(m, work.implicit.u, work.implicit);
  result.is_implicit = result.steepness > steepness_limit;
  if (!result.is_implicit) return result;
  result.search = find_resisted_velocity(m, work.implicit);
  take_loads(m, work.implicit, loads);
  take_velocity(m, work.implicit.u, velocity);
  return result;
}

void opening_loads(const LoadedMotion& motion, dynamics::DrillingWork& drive_work,
                   ImplicitStepWork& work, BitLoads& loads) {
  dynamics::find_response(motion.c.drilling.system, motion.dt, motion.drive,
                          dynamics::RemainingKicks::opening, drive_work, work.responding,
                          work.response);
  const ResistedMotion m = resisted(motion, work);
  start_at_momenta(motion, drive_work, work);
  prepare(m, work.implicit);
  find_resisted_velocity(m, work.implicit);
  take_loads(m, work.implicit, loads);
}

}  // namespace tdbd::simulation
