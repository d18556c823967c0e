#include "simulation/step/drive.hpp"

#include <algorithm>
#include <cmath>

#include "bit/cone/cone_bit.hpp"
#include "rotation/quaternion.hpp"
#include "rotation/screw.hpp"

namespace tdbd::simulation {
namespace {

/// Adds the contacts of a step to the faded sums. Returns the speed at which they balance.
double balanced_speed(ConeState& cone, const bit::SlipBalance& now, double fading) {
  constexpr double forgotten = 1e-200;  // smaller sums are unreliable and not used
  cone.remembered.moment = fading * cone.remembered.moment + now.moment;
  cone.remembered.inertia = fading * cone.remembered.inertia + now.inertia;
  if (cone.remembered.inertia < forgotten) return cone.speed;
  return -cone.remembered.moment / cone.remembered.inertia;
}

/// `pure_speed` is that of the gage row, rad/s.
double rolling_speed(ConeState& cone, const bit::SlipBalance& now, double fading,
                     double pure_speed) {
  if (now.inertia > 0.0 || cone.start_share < 1.0) cone.start_share *= fading;
  if (cone.start_share == 1.0) return pure_speed;
  const double balanced = balanced_speed(cone, now, fading);
  return cone.start_share * pure_speed + (1.0 - cone.start_share) * balanced;
}

/// Speeds of rolling cones in the next step, rad/s.
std::vector<double> rolling_speeds(const Case& c, long steps_done, const rock::CutReport& cut,
                                   std::vector<ConeState>& cones) {
  const double dt = c.time.step;
  const rotation::Twist twist =
      rotation::twist_from(pose_at(c.motion, time_at(c.time, steps_done)),
                           pose_at(c.motion, time_at(c.time, steps_done + 1)), dt);
  const double fading = c.motion.cones.memory > 0.0 ? std::exp(-dt / c.motion.cones.memory) : 0.0;
  const std::vector<double> angles = middle_angles(cones, dt);
  std::vector<double> speeds;
  for (std::size_t k = 0; k < cones.size(); ++k) {
    const bit::SlipBalance now = bit::slip_balance(
        c.bit.cones[k].X_BK, twist, contacts_of(c.bit, static_cast<int>(k), angles, cut));
    const double pure = -bit::rolling_ratio_of_gage_row(c.bit.cones[k]) * twist.angular_B.z();
    speeds.push_back(rolling_speed(cones[k], now, fading, pure));
  }
  return speeds;
}

}  // namespace

void set_angle(ConeState& cone, double angle) {
  cone.turned = angle - cone.angle;
  cone.angle = angle;
}

void add(double turn, const std::vector<ConeState>& cones, std::vector<ConeStatistics>& all) {
  for (std::size_t k = 0; k < cones.size(); ++k) {
    ConeStatistics& s = all[k];
    s.bit_turned += turn;
    if (turn == 0.0) continue;
    const double ratio = -cones[k].turned / turn;
    add(s.ratio, ratio);
    s.least = s.ratio.count == 1 ? ratio : std::min(s.least, ratio);
    s.greatest = s.ratio.count == 1 ? ratio : std::max(s.greatest, ratio);
  }
}

std::vector<ConeState> start_cones(const Case& c) {
  std::vector<ConeState> cones(c.bit.cones.size());
  const std::vector<double> angles = cone_angles(c.motion, time_at(c.time, c.time.first));
  for (std::size_t k = 0; k < angles.size(); ++k) cones[k].angle = angles[k];
  return cones;
}

std::vector<bit::ConeContact> contacts_of(const bit::Bit& bit, int cone,
                                          const std::vector<double>& cone_angles,
                                          const rock::CutReport& cut) {
  std::vector<bit::ConeContact> contacts;
  for (std::size_t i = 0; i < cut.removed_by_part.size(); ++i) {
    const bit::Part& part = bit.parts[i];
    if (part.kind != bit::PartKind::tooth || part.cone != cone || !(cut.removed_by_part[i] > 0.0))
      continue;
    contacts.push_back(
        {bit::part_pose(bit, part, cone_angles) * bit::tooth_tip_P(part), cut.removed_by_part[i]});
  }
  return contacts;
}

void turn_cones(const Case& c, long steps_done, const rock::CutReport& cut,
                std::vector<ConeState>& cones) {
  if (c.motion.cones.drive == ConeDrive::rolling) {
    const std::vector<double> speeds = rolling_speeds(c, steps_done, cut, cones);
    for (std::size_t k = 0; k < cones.size(); ++k) {
      set_angle(cones[k], cones[k].angle + c.time.step * speeds[k]);
      cones[k].speed = speeds[k];
    }
    return;
  }
  const std::vector<double> given = cone_angles(c.motion, time_at(c.time, steps_done + 1));
  for (std::size_t k = 0; k < cones.size(); ++k) {
    set_angle(cones[k], given[k]);
    cones[k].speed = cones[k].turned / c.time.step;
  }
}

std::vector<double> angles_of(const std::vector<ConeState>& cones) {
  std::vector<double> angles;
  angles.reserve(cones.size());
  for (const ConeState& cone : cones) angles.push_back(cone.angle);
  return angles;
}

std::vector<double> middle_angles(const std::vector<ConeState>& cones, double dt) {
  std::vector<double> angles;
  angles.reserve(cones.size());
  for (const ConeState& cone : cones) angles.push_back(cone.angle - 0.5 * dt * cone.speed);
  return angles;
}

std::vector<double> speeds_of(const std::vector<ConeState>& cones) {
  std::vector<double> speeds;
  speeds.reserve(cones.size());
  for (const ConeState& cone : cones) speeds.push_back(cone.speed);
  return speeds;
}

ConeSummary summarize(const bit::Cone& cone, const ConeState& state, const ConeStatistics& s) {
  ConeSummary f{.name = cone.name, .steps = s.ratio.count};
  if (s.bit_turned != 0.0) f.mean_speed_ratio = -state.angle / s.bit_turned;
  f.min_speed_ratio = s.least;
  f.max_speed_ratio = s.greatest;
  f.std_speed_ratio = deviation(s.ratio);
  f.rolling_ratio_gage_row = bit::rolling_ratio_of_gage_row(cone);
  if (f.rolling_ratio_gage_row > 0.0)
    f.net_slip_gage_row = 1.0 - f.mean_speed_ratio / f.rolling_ratio_gage_row;
  return f;
}

dynamics::Drilling start_drive(const Case& c) {
  return dynamics::start_drilling(c.drilling.system, c.drilling.start, c.drilling.chain);

}  // namespace tdbd::simulation

Place place_of(const dynamics::DrillingSystem& system, const dynamics::DrillingState& state) {
  return {dynamics::bit_pose(system, state),
          rotation::twist_angle(state.rotation.q_WB, state.rotation.turns), state.rock_z};
}

BitVelocity velocity_of(const dynamics::DrillingSystem& system,
                        const dynamics::DrillingState& state) {
  const dynamics::DrillingVelocity v = dynamics::velocity(system, state);
  BitVelocity over_rock;
  over_rock.p_WB = dynamics::bit_pose(system, state).p;
  over_rock.v_W = dynamics::point_velocity(v, over_rock.p_WB - state.c_W);
  over_rock.p_WB.z() -= state.rock_z;
  over_rock.v_W.z() -= v.rock;
  over_rock.w_W = v.w_W;
  over_rock.cone_speeds = v.cone_rates;
  return over_rock;
}

dynamics::Wrench wrench_of(const dynamics::DrillingSystem& system, const BitLoads& loads,
                           const Pose& X_RB) {
  dynamics::Wrench w;
  w.force_W = loads.force_W;
  w.torque_W = loads.torque_W - (X_RB.R * system.centre_B).cross(loads.force_W);
  w.cones = loads.cone_torques;
  w.rock_force = -loads.force_W.z();
  w.cone_impulse = dynamics::ConeImpulse::at_end;
  return w;
}

void follow_cones(const dynamics::DrillingState& state, double dt, std::vector<ConeState>& cones) {
  for (std::size_t k = 0; k < cones.size(); ++k) {
    set_angle(cones[k], state.rotation.cone_angles[k]);
    cones[k].speed = cones[k].turned / dt;
  }
}

}  // namespace tdbd::simulation
