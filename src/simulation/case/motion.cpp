#include "simulation/case/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rotation/screw.hpp"

namespace tdbd::simulation {
namespace {

double ramp_fraction(double ramp, double t) { return ramp > 0.0 ? std::min(1.0, t / ramp) : 1.0; }

double sign(WhirlSense sense) { return sense == WhirlSense::forward ? 1.0 : -1.0; }

Vec3 orbit(const Whirl& w, double t) {
  const double angle = sign(w.sense) * w.frequency * t;
  return w.radius * ramp_fraction(w.ramp, t) * Vec3(std::cos(angle), std::sin(angle), 0.0);
}

/// The rotation that takes z to the leaning axis: about the horizontal perpendicular to the lean.
Mat3 lean(const Tilt& tilt, double t) {
  const double azimuth = tilt.azimuth + sign(tilt.sense) * tilt.frequency * t;
  return rotation::exp(tilt.angle * ramp_fraction(tilt.ramp, t) *
                       Vec3(-std::sin(azimuth), std::cos(azimuth), 0.0));
}

/// The rows around t, and how far t is between them.
struct Rows {
  const PathPoint *before, *after;
  double fraction;
};

Rows rows_around(const std::vector<PathPoint>& path, double t) {
  const auto after = std::upper_bound(
      path.begin(), path.end(), t, [](double time, const PathPoint& p) { return time < p.time; });
  if (after == path.begin()) return {&path.front(), &path.front(), 0.0};
  if (after == path.end()) return {&path.back(), &path.back(), 0.0};
  const PathPoint& a = *(after - 1);
  return {&a, &*after, (t - a.time) / (after->time - a.time)};
}

Vec3 turn_between(const PathPoint& a, const PathPoint& b) {
  return rotation::log(rotation::exp(a.rotation_WB).transpose() * rotation::exp(b.rotation_WB));
}

Pose pose_on(const std::vector<PathPoint>& path, double t) {
  const Rows at = rows_around(path, t);
  const Vec3 turn = at.fraction * turn_between(*at.before, *at.after);
  return {rotation::exp(at.before->rotation_WB) * rotation::exp(turn),
          (1.0 - at.fraction) * at.before->p_WB + at.fraction * at.after->p_WB};
}

}  // namespace

Pose pose_at(const Motion& m, double t) {
  if (has_path(m)) return pose_on(m.path, t);
  Pose X_WB{rotation::exp(Vec3(0.0, 0.0, m.rotary_speed * t)),
            m.start_W + Vec3(0.0, 0.0, m.rate_of_penetration * t)};
  if (m.kind == MotionKind::whirl) X_WB.p += orbit(m.whirl, t);
  if (m.tilt.angle > 0.0) X_WB.R = lean(m.tilt, t) * X_WB.R;
  return X_WB;
}

void sum_turns(std::vector<PathPoint>& path) {
  for (std::size_t i = 1; i < path.size(); ++i)
    path[i].turned = path[i - 1].turned + turn_between(path[i - 1], path[i]).z();
}

std::vector<PathPoint> path_of(const std::vector<Leg>& legs, const Vec3& start_W) {
  constexpr double quarter_turn = 0.5 * std::numbers::pi;
  std::vector<PathPoint> path{{0.0, start_W, Vec3::Zero()}};
  for (const Leg& leg : legs) {
    const PathPoint from = path.back();
    const double turn = leg.rotary_speed * leg.duration;
    const long rows = std::max(1L, std::lround(std::ceil(std::abs(turn) / quarter_turn)));
    for (long k = 1; k <= rows; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(rows);
      path.push_back({from.time + share * leg.duration,
                      from.p_WB + share * leg.duration * leg.velocity_W,
                      from.rotation_WB + share * turn * Vec3::UnitZ()});
    }
  }
  sum_turns(path);
  return path;
}

double angle_turned(const Motion& m, double t) {
  if (!has_path(m)) return m.rotary_speed * t;
  const Rows at = rows_around(m.path, t);
  return (1.0 - at.fraction) * at.before->turned + at.fraction * at.after->turned;
}

std::vector<double> cone_angles(const Motion& m, double t) {
  std::vector<double> angles;
  for (const double speed : m.cone_speeds) angles.push_back(-speed * angle_turned(m, t));
  return angles;
}

}  // namespace tdbd::simulation
