#include "simulation/motion.hpp"

#include <algorithm>
#include <cmath>

#include "rotation/rotation_vector.hpp"

namespace tdbd::simulation {
namespace {

Vec3 orbit(const Whirl& w, double t) {
  const double grown = w.ramp > 0.0 ? std::min(1.0, t / w.ramp) : 1.0;
  const double angle = (w.sense == WhirlSense::forward ? 1.0 : -1.0) * w.frequency * t;
  return w.radius * grown * Vec3(std::cos(angle), std::sin(angle), 0.0);
}

/// Rows around t, and how far t is between them.
struct Place {
  const PathPoint *before, *after;
  double fraction;
};

Place place_on(const std::vector<PathPoint>& path, double t) {
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
  const Place at = place_on(path, t);
  const Vec3 turn = at.fraction * turn_between(*at.before, *at.after);
  return {rotation::exp(at.before->rotation_WB) * rotation::exp(turn),
          (1.0 - at.fraction) * at.before->p_WB + at.fraction * at.after->p_WB};
}

}  // namespace

Pose pose_at(const Motion& m, double t) {
  if (m.kind == MotionKind::table) return pose_on(m.path, t);
  Pose X_WB{rotation::exp(Vec3(0.0, 0.0, m.rotary_speed * t)),
            Vec3(0.0, 0.0, m.rate_of_penetration * t)};
  if (m.kind == MotionKind::whirl) X_WB.p += orbit(m.whirl, t);
  return X_WB;
}

void sum_turns(std::vector<PathPoint>& path) {
  for (std::size_t i = 1; i < path.size(); ++i)
    path[i].turned = path[i - 1].turned + turn_between(path[i - 1], path[i]).z();
}

double angle_turned(const Motion& m, double t) {
  if (m.kind != MotionKind::table) return m.rotary_speed * t;
  const Place at = place_on(m.path, t);
  return (1.0 - at.fraction) * at.before->turned + at.fraction * at.after->turned;
}

std::vector<double> cone_angles(const Motion& m, double t) {
  std::vector<double> angles;
  for (const double speed : m.cone_speeds) angles.push_back(-speed * angle_turned(m, t));
  return angles;
}

}  // namespace tdbd::simulation
