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
  const bool follows = w.system.string.damper_end == DamperEnd::top;
  const double rate = follows ? value_at(w.system.top.rate, w.state.rotation.time) : 0.0;
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

/// Friction that slows; returns what it took, J.
double rub(const Sweeping& w, const Direction& direction, double force, double slip_speed) {
  const Along a = along(w.system, w.at, w.state, direction);
  const double j = friction_impulse(a, force, slip_speed, w.time);
  give_impulse(direction, j, w.state);
  return -energy_of_impulse(a, j);
}

Direction radial(const WallContact& c) { return {c.outward_W, c.ring_arm_W.cross(c.outward_W)}; }
Direction at_touch(const WallContact& c, const Vec3& along_W) {
  return {along_W, c.touch_arm_W.cross(along_W)};
}

/// How the touching point slips over the wall, around it and along z, and what impulses do to that.
struct WallSlip {
  Eigen::Vector2d speed;     ///< m/s
  Eigen::Matrix2d mobility;  ///< 1/kg
};

WallSlip slip_on_wall(const Sweeping& w) {
  const Direction around = at_touch(w.at.contact, w.at.contact.tangent_W),
                  down = at_touch(w.at.contact, Vec3::UnitZ());
  const Along a = along(w.system, w.at, w.state, around), z = along(w.system, w.at, w.state, down);
  const double across = around.torque_W.dot(w.at.mobility_W * down.torque_W);
  WallSlip slip{{a.speed, z.speed}, {}};
  slip.mobility << a.mobility, across, across, z.mobility;
  return slip;
}

/// Friction's own way, of the slip's: the mean of where it points before and after, so that the
/// step keeps its order where friction turns it. No direction at rest.
Eigen::Vector2d mean_direction(const WallSlip& slip, double force, double slip_speed, double time) {
  const double speed = slip.speed.norm();
  if (speed == 0.0) return Eigen::Vector2d::UnitX();
  const Eigen::Vector2d e = slip.speed / speed;
  const double j = friction_impulse({speed, e.dot(slip.mobility * e)}, force, slip_speed, time);
  // Friction stops the slip at the most, so that the sum keeps a part along e.
  return (2.0 * slip.speed + j * slip.mobility * e).normalized();
}

/// k p while pressing and e^2 k p while letting go are the mean spring and a friction of half the
/// difference.
void lose_at_wall(const Sweeping& w) {
  const Wall& wall = w.system.wall;
  const double half_difference =
      0.5 * wall.stiffness * (1.0 - wall.restitution * wall.restitution) * w.at.contact.depth;
  w.ledger.wall_loss += rub(w, radial(w.at.contact), half_difference, 0.0);
}

void rub_on_wall(const Sweeping& w) {
  const Wall& wall = w.system.wall;
  if (wall.friction == 0.0) return;
  const Along a = along(w.system, w.at, w.state, radial(w.at.contact));
  const double e2 = a.speed < 0.0 ? wall.restitution * wall.restitution : 1.0;
  const double normal = wall.stiffness * e2 * w.at.contact.depth;
  const double force = wall.friction * normal;
  const Eigen::Vector2d e = mean_direction(slip_on_wall(w), force, wall.slip_speed, w.time);
  const Vec3 way_W = e.x() * w.at.contact.tangent_W + e.y() * Vec3::UnitZ();
  w.ledger.wall_friction += rub(w, at_touch(w.at.contact, way_W), force, wall.slip_speed);
}

/// The i-th of all that takes energy: three and three of the string, bearings, rock, two of the
/// wall.
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
  } else if (w.at.contact.depth > 0.0 && i == 7 + cones) {
    lose_at_wall(w);
  } else if (w.at.contact.depth > 0.0 && i == 8 + cones) {
    rub_on_wall(w);
  }
}

}  // namespace

void dissipate(const DrillingSystem& system, const Configuration& at, Sweep sweep, double time,
               DrillingState& state, EnergyLedger& ledger) {
  const Sweeping w{system, at, time, state, ledger};
  const std::size_t n = 9 + system.gyrostat.cones.size();
  for (std::size_t i = 0; i < n; ++i) take(w, sweep == Sweep::forward ? i : n - 1 - i);
}

}  // namespace tdbd::dynamics
