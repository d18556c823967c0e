#include "simulation/step/standing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rotation/rotation_vector.hpp"
#include "simulation/step/drive.hpp"
#include "simulation/step/step.hpp"

namespace tdbd::simulation {
namespace {

/// Above this steepness an explicit impulse overshoots. Bits that drill on faces are well below it.
constexpr double too_steep = 1.0;

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
double moved_by_a_force(const dynamics::DrillingSystem& s) {
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

}  // namespace

void add(const Standing& step, StandingStatistics& s) {
  if (!step.stands) return;
  ++s.steps;
  if (!step.search.is_settled) ++s.unsettled;
  s.most_rounds = std::max<long>(s.most_rounds, step.search.rounds);
}

void stand(const Case& c, const Move& move, const State& state, Work& work) {
  work.standing = {};
  if (work.cuts.empty()) return;
  const dynamics::DrillingSystem& system = c.drilling.system;
  const dynamics::DrillingState& now = state.drive->state;
  StandingWork& room = work.standing_work;
  const ResistedMotion m{c.forces, c.bit,     move.X_WB1,   now.c_W - now.rock_z * Vec3::UnitZ(),
                         move.dt,  work.cuts, room.response};
  dynamics::velocity(system, work.drive.at, now, room.responding.velocity);
  dynamics::to_column(system, room.responding.velocity, room.implicit.u);
  take_velocity(m, room.implicit.u, room.last_drift);
  work.standing.steepness =
      steepness_bound(m, room.last_drift, work.drive.at.mobility_W, moved_by_a_force(system));
  if (work.standing.steepness <= too_steep) return;
  dynamics::find_response(system, move.dt, *state.drive, dynamics::KicksLeft::closing_and_opening,
                          work.drive, room.responding, room.response);
  prepare(m, room.implicit);
  if (std::isfinite(work.standing.steepness) && !any_presses(room.implicit))
    work.standing.steepness = steepness(m, room.implicit.u, room.implicit);
  work.standing.stands = work.standing.steepness > too_steep;
  if (!work.standing.stands) return;
  work.standing.search = find_resisted_velocity(m, room.implicit);
  take_loads(m, room.implicit, work.loads);
  take_velocity(m, room.implicit.u, work.velocity);
}

void bear_at_start(const Case& c, State& state, Work& work) {
  if (!state.drive || c.forces.forces == Forces::off || c.measure.contact == ContactMeasure::off)
    return;
  const Pose X_WB = over_rock(state.place);
  rock::begin_at_rest(work.cutting, X_WB, work.cut_work);
  rock::contact_areas(state.rock, work.cutting, work.cut_work,
                      {c.measure.contact_gap * c.rock.edge_length, work.contacts},
                      work.measure_work.contact, work.measures.contacts);
  measure_rubbing(c, X_WB, state, work);
  gather_touching(c.forces, c.bit, work.measures.contacts, work.cuts);
  if (work.cuts.empty()) return;
  const dynamics::DrillingSystem& system = c.drilling.system;
  const dynamics::DrillingState& now = state.drive->state;
  StandingWork& room = work.standing_work;
  dynamics::find_response(system, c.time.step, *state.drive, dynamics::KicksLeft::opening,
                          work.drive, room.responding, room.response);
  const ResistedMotion m{c.forces,    c.bit,     X_WB,         now.c_W - now.rock_z * Vec3::UnitZ(),
                         c.time.step, work.cuts, room.response};
  dynamics::velocity(system, work.drive.at, now, room.responding.velocity);
  dynamics::to_column(system, room.responding.velocity, room.implicit.u);
  prepare(m, room.implicit);
  find_resisted_velocity(m, room.implicit);
  take_loads(m, room.implicit, work.loads);
  state.drive->wrench = wrench_of(system, work.loads, X_WB);
  state.drive->wrench.cone_impulse = dynamics::ConeImpulse::halves;
  work.cuts.clear();  // they belong to no step
  work.loads = {};
}

}  // namespace tdbd::simulation
