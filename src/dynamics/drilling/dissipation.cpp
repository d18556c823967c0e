#include "dynamics/drilling/dissipation.hpp"

namespace tdbd::dynamics {
namespace {

/// What a sweep carries along.
struct Sweeping {
  const DrillingSystem& system;
  const Configuration& at;
  double time;
  DrillingState& state;
  EnergyLedger& ledger;
};

/// One damper of the string. Its other end moves with the top, which then works on it.
void damp_string(const Sweeping& w, const PrincipalDamper& damper, const Direction& direction,
                 const Vec3& top_velocity_W) {
  if (damper.coefficient == 0.0) return;
  const Along a = along(w.system, w.at, w.state, direction);
  const double top_speed = damper.axis_W.dot(top_velocity_W);
  const double j = damper_impulse(a, damper.coefficient, top_speed, w.time);
  give_impulse(direction, j, w.state);
  w.ledger.top += j * top_speed;
  w.ledger.damped_string += j * top_speed - energy_of_impulse(a, j);
}

void damp_translation(const Sweeping& w, const PrincipalDamper& damper) {
  const double rate = rate_of_damper_end(w.system, w.state);
  damp_string(w, damper, {damper.axis_W, w.at.pull.arm_W.cross(damper.axis_W)},
              rate * Vec3::UnitZ());
}

void damp_rotation(const Sweeping& w, const PrincipalDamper& damper) {
  const bool follows = w.system.string.damper_end == DamperEnd::top;
  const double speed = follows ? value_at(w.system.top.speed, w.state.rotation.time) : 0.0;
  damp_string(w, damper, {Vec3::Zero(), damper.axis_W}, speed * Vec3::UnitZ());
}

/// A damper to rest; returns what it took, J.
double damp(const Sweeping& w, const Direction& direction, double coefficient) {
  if (coefficient == 0.0) return 0.0;
  const Along a = along(w.system, w.at, w.state, direction);
  const double j = damper_impulse(a, coefficient, 0.0, w.time);
  give_impulse(direction, j, w.state);
  return -energy_of_impulse(a, j);
}

/// The i-th of all that takes energy: three and three of the string, bearings, rock.
void take(const Sweeping& w, std::size_t i) {
  const std::size_t cones = w.system.gyrostat.cones.size();
  if (i < 3) return damp_translation(w, w.system.dampers[i]);
  if (i < 6) return damp_rotation(w, w.system.turn_dampers[i - 3]);
  if (i < 6 + cones) {
    Direction bearing;
    bearing.cone = static_cast<int>(i - 6);
    w.ledger.damped_bearings += damp(w, bearing, w.system.bearing_damping[i - 6]);
  } else if (i == 6 + cones && w.system.rock.mass > 0.0) {
    Direction mount;
    mount.rock = 1.0;
    w.ledger.damped_rock += damp(w, mount, w.system.rock.damping);
  }
}

}  // namespace

void dissipate(const DrillingSystem& system, const Configuration& at, Sweep sweep, double time,
               DrillingState& state, EnergyLedger& ledger) {
  const Sweeping w{system, at, time, state, ledger};
  const std::size_t n = 7 + system.gyrostat.cones.size();
  if (sweep == Sweep::forward) follow_bit(system, at, time, state);
  for (std::size_t i = 0; i < n; ++i) take(w, sweep == Sweep::forward ? i : n - 1 - i);
  if (sweep == Sweep::backward) follow_bit(system, at, time, state);
}

}  // namespace tdbd::dynamics
