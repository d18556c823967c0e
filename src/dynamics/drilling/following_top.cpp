#include "dynamics/drilling/following_top.hpp"

#include <cmath>

#include "dynamics/drilling/exact_flow.hpp"

namespace tdbd::dynamics {
namespace {

/// Whether the rate of the top is a part of the state.
bool top_follows_bit(const DrillingSystem& s) {
  return s.string.damper_end == DamperEnd::top && s.top.axial == AxialMode::load &&
         s.top.following_time > 0.0;
}

}  // namespace

double rate_of_damper_end(const DrillingSystem& s, const DrillingState& state) {
  if (s.string.damper_end == DamperEnd::space) return 0.0;
  return top_follows_bit(s) ? state.top_rate : value_at(s.top.rate, state.rotation.time);
}

void follow_bit(const DrillingSystem& s, const Configuration& at, double time,
                DrillingState& state) {
  if (!top_follows_bit(s)) return;
  const Direction down{Vec3::UnitZ(), at.pull.arm_W.cross(Vec3::UnitZ())};
  const double speed = along(s, at, state, down).speed;
  state.top_rate -= (speed - state.top_rate) * std::expm1(-time / s.top.following_time);
}

}  // namespace tdbd::dynamics
