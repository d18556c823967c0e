#include "simulation/step/cone_motion.hpp"

#include <algorithm>
#include <cmath>

#include "bit/cone/part_pose.hpp"
#include "rotation/rotation_vector.hpp"

namespace tdbd::simulation {
namespace {

double time_of(const Case& c, long steps) { return c.time.step * static_cast<double>(steps); }

/// Adds the contacts of a step to those remembered; the speed at which they balance.
double balanced_speed(ConeState& cone, const bit::SlipBalance& now, double fading) {
  constexpr double forgotten = 1e-200;  // contacts fade to nothing before their sums lose digits
  cone.remembered.moment = fading * cone.remembered.moment + now.moment;
  cone.remembered.inertia = fading * cone.remembered.inertia + now.inertia;
  if (cone.remembered.inertia < forgotten) return cone.speed;
  return -cone.remembered.moment / cone.remembered.inertia;
}

/// pure_speed: of the gage row, rad/s.
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
  const double dt = c.time.step, t = time_of(c, steps_done);
  const rotation::Twist twist =
      twist_between(pose_at(c.motion, t), pose_at(c.motion, time_of(c, steps_done + 1)), dt);
  const double fading = c.motion.cone_memory > 0.0 ? std::exp(-dt / c.motion.cone_memory) : 0.0;
  const std::vector<double> angles = middle_angles(cones, dt);
  std::vector<double> speeds;
  for (std::size_t k = 0; k < cones.size(); ++k) {
    const bit::SlipBalance now = bit::slip_balance(
        c.bit.cones[k].X_BK, twist, contacts_of(c.bit, static_cast<int>(k), angles, cut));
    const double pure = -cones[k].rolling_ratio * twist.angular_B.z();
    speeds.push_back(rolling_speed(cones[k], now, fading, pure));
  }
  return speeds;
}

}  // namespace

void add(SpeedRatios& r, double ratio) {
  ++r.count;
  r.least = r.count == 1 ? ratio : std::min(r.least, ratio);
  r.greatest = r.count == 1 ? ratio : std::max(r.greatest, ratio);
  const double before = ratio - r.mean;
  r.mean += before / static_cast<double>(r.count);
  r.squares += before * (ratio - r.mean);
}

std::vector<ConeState> start_cones(const Case& c) {
  std::vector<ConeState> cones;
  const double t = time_of(c, c.time.first);
  const std::vector<double> angles = cone_angles(c.motion, t);
  for (const bit::Cone& cone : c.bit.cones) {
    ConeState& state = cones.emplace_back();
    state.rolling_ratio = bit::rolling_ratio_of_gage_row(cone);
    if (!angles.empty()) state.angle = angles[cones.size() - 1];
    state.bit_turned = angle_turned(c.motion, t);
  }
  return cones;
}

rotation::Twist twist_between(const Pose& X_WB0, const Pose& X_WB1, double dt) {
  const Vec3 turn = rotation::log(X_WB0.R.transpose() * X_WB1.R);
  const Mat3 R_WM = X_WB0.R * rotation::exp(0.5 * turn);
  return {turn / dt, R_WM.transpose() * (X_WB1.p - X_WB0.p) / dt};
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
  const double t0 = time_of(c, steps_done), t1 = time_of(c, steps_done + 1);
  const double bit_turn = angle_turned(c.motion, t1) - angle_turned(c.motion, t0);
  const bool rolling = c.motion.cone_drive == ConeDrive::rolling;
  const std::vector<double> speeds =
      rolling ? rolling_speeds(c, steps_done, cut, cones) : std::vector<double>{};
  const std::vector<double> given = cone_angles(c.motion, t1);
  for (std::size_t k = 0; k < cones.size(); ++k) {
    const double before = cones[k].angle;
    cones[k].angle = rolling ? before + c.time.step * speeds[k] : given[k];
    cones[k].speed = rolling ? speeds[k] : (given[k] - before) / c.time.step;
    cones[k].bit_turned += bit_turn;
    if (bit_turn != 0.0) add(cones[k].ratios, (before - cones[k].angle) / bit_turn);
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

ConeFigures figures_of(const std::string& name, const ConeState& cone) {
  const SpeedRatios& r = cone.ratios;
  ConeFigures f{name};
  if (cone.bit_turned != 0.0) f.mean_speed_ratio = -cone.angle / cone.bit_turned;
  f.min_speed_ratio = r.least;
  f.max_speed_ratio = r.greatest;
  if (r.count > 0) f.std_speed_ratio = std::sqrt(r.squares / static_cast<double>(r.count));
  f.rolling_ratio_gage_row = cone.rolling_ratio;
  if (cone.rolling_ratio > 0.0) f.net_slip_gage_row = 1.0 - f.mean_speed_ratio / cone.rolling_ratio;
  return f;
}

}  // namespace tdbd::simulation
