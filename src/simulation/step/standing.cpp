#include "simulation/step/standing.hpp"

#include <algorithm>

#include "rotation/rotation_vector.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {
namespace {

/// Above this an explicit impulse overshoots. Bits that drill on faces stay well below.
constexpr double too_steep = 1.0;

/// The motion of the bit over the rock that velocities u are.
void take_velocity(const ResistedMotion& m, const Eigen::VectorXd& u, BitVelocity& v) {
  const auto cones = static_cast<int>(m.bit.cones.size());
  v.p_WB = m.X_WB.p;
  v.w_W = u.segment<3>(3);
  v.v_W = Vec3(u.head<3>()) + v.w_W.cross(v.p_WB - m.centre_W);
  if (u.size() > 6 + cones) v.v_W.z() -= u[6 + cones];
  v.cone_speeds.resize(at(cones));
  for (int k = 0; k < cones; ++k) v.cone_speeds[at(k)] = u[6 + k];
}

/// 1/kg, of bit and rock.
double moved_by_a_force(const dynamics::DrillingSystem& s) {
  return 1.0 / s.mass + (s.rock.mass > 0.0 ? 1.0 / s.rock.mass : 0.0);
}

/// A bound of the steepness that needs neither probes nor sums: |C_i| is |F_i|/|v_i|, and a step
/// gives way by no more than h M^-1. Cones are left out, since they are eliminated.
double steepness_bound(const ResistedMotion& m, const BitVelocity& v, const Mat3& turned_by,
                       double moved_by) {
  double bound = 0.0;
  for (const CutOfPart& cut : m.cuts) {
    const Vec3 v_W = velocity_at(m.bit, m.X_WB, v, cut.cone, cut.cut.point);
    const double force = drag_of(m.plan, cut, v_W, m.dt, Resistance::none).force.force.norm();
    const Mat3 arm = rotation::skew(cut.cut.point - m.centre_W);
    const double gives = moved_by + (arm * turned_by * arm.transpose()).norm();
    bound += m.dt * force / std::max(v_W.norm(), smallest_speed) * gives;
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
  dynamics::find_response(system, move.dt, *state.drive, work.drive, room.responding,
                          room.response);
  prepare(m, room.implicit);
  work.standing.steepness = steepness(m, room.implicit.u, room.implicit);
  work.standing.stands = work.standing.steepness > too_steep;
  if (!work.standing.stands) return;
  work.standing.search = find_resisted_velocity(m, room.implicit);
  take_loads(m, room.implicit, work.loads);
  take_velocity(m, room.implicit.u, work.velocity);
}

}  // namespace tdbd::simulation
