#include "string/simple_bit.hpp"

#include <algorithm>
#include <cmath>

#include "core/types.hpp"
#include "string/node_flow.hpp"

namespace tdbd::string {
namespace {

/// Data of one direction of the bit.
struct Drive {
  DampedBody body;
  double force = 0.0;     ///< of string, weight and cutting
  double friction = 0.0;  ///< friction level while moving
  double resting = 0.0;   ///< friction level at rest
};

/// Computes one flow and adds its losses. Returns the new speed.
double flow_one(const Drive& d, double time, double speed, Lost& lost) {
  const double next = flow_along(d.body, d.force, {d.resting, d.friction, 0.0}, time, speed);
  const double level = speed != 0.0 || next != 0.0 ? d.friction : d.resting;
  add_flow_losses({{speed, 0.0}, {next, 0.0}, {d.force, 0.0}, level, time}, {d.body.mass, 0.0},
                  {d.body.damping, 0.0}, lost);
  return next;
}

/// Weight on bit without contact of wear flats, N.
double cutting_force(const SimpleBit& b, const BitState& s) {
  return b.weight + (b.law == BitLaw::regenerative ? b.force_per_depth * s.depth : 0.0);
}

/// The flow along the hole. The contact force of wear flats acts on the way down and vanishes on
/// the way up; it is represented by half of it as a constant force and half as friction.
double flow_down(const SimpleBit& b, double time, double pull, BitState& s, Lost& lost) {
  const double half = b.law == BitLaw::regenerative ? 0.5 * b.contact_force : 0.0;
  const Drive drive{
      {b.mass, b.axial_damping}, b.gravity_force - pull - cutting_force(b, s) - half, half, half};
  const double next = flow_one(drive, time, s.velocity, lost);
  s.contact = 0.0;
  if (half > 0.0) {
    const double mean = 0.5 * (s.velocity + next);
    const double friction =
        b.mass * (next - s.velocity) - time * (drive.force - b.axial_damping * mean);
    s.contact = std::clamp(0.5 - 0.5 * friction / (time * half), 0.0, 1.0);
    lost.friction += time * half * mean;  // the half that is a force
  }
  return next;
}

double friction_torque(const SimpleBit& b, const BitState& s) {
  if (b.law == BitLaw::two_level) return b.sliding_torque;
  if (b.law != BitLaw::regenerative) return 0.0;
  return b.torque_per_depth * s.depth + b.contact_lever * b.contact_force * s.contact;
}

double flow_round(const SimpleBit& b, double time, double torque, const BitState& s, Lost& lost) {
  const double sliding = friction_torque(b, s);
  const double resting = b.law == BitLaw::two_level ? b.resting_torque : sliding;
  return flow_one({{b.inertia, b.torsional_damping}, torque - b.torque, sliding, resting}, time,
                  s.rotary_speed, lost);
}

/// Computes the depth of cut below the surface left by the preceding blade at this angle. Where the
/// bit is above that surface, the rock is unchanged.
void find_depth(const SimpleBit& b, BitState& s) {
  if (b.law != BitLaw::regenerative) return;
  auto &angle = s.past_angle, &u = s.past_displacement;
  if (angle.empty()) {
    angle.push_back(s.angle);
    u.push_back(s.displacement);
  }
  const double ahead = s.angle - b.pitch;
  std::size_t k = static_cast<std::size_t>(s.oldest);
  while (k + 2 < angle.size() && angle[k + 1] <= ahead) ++k;
  double cut = u[k];
  if (k + 1 < angle.size() && ahead > angle[k])
    cut += (ahead - angle[k]) / (angle[k + 1] - angle[k]) * (u[k + 1] - u[k]);
  s.depth = std::max(0.0, s.displacement - cut);
  const double bottom = std::max(s.displacement, cut);
  if (s.angle > angle.back()) {
    angle.push_back(s.angle);
    u.push_back(bottom);
  } else {
    u.back() = bottom;
  }
  if (k > 4096 && 2 * k > angle.size()) {
    angle.erase(angle.begin(), angle.begin() + static_cast<std::ptrdiff_t>(k));
    u.erase(u.begin(), u.begin() + static_cast<std::ptrdiff_t>(k));
    k = 0;
  }
  s.oldest = static_cast<long>(k);
}

}  // namespace

SimpleBit bit_below(const Chain& chain, double mass, double inertia, double weight) {
  SimpleBit b;
  b.directions = chain.directions;
  b.mass = mass + chain.elements.mass.back();
  b.inertia = inertia + chain.elements.inertia.back();
  b.gravity_force = weight + chain.contact.weight.back();
  b.axial_damping = chain.axial_damping * chain.elements.mass.back();
  b.torsional_damping = chain.torsional_damping * chain.elements.inertia.back();
  return b;
}

void start_cut(const SimpleBit& b, double depth, BitState& s) {
  s.past_angle = {s.angle - 2.0 * b.pitch, s.angle};
  s.past_displacement = {s.displacement - 2.0 * depth, s.displacement};
  s.oldest = 0;
  find_depth(b, s);
}

void flow_bit(const SimpleBit& b, double time, const EndLoad& load, const EndLoad& damper,
              double set_speed, BitState& s) {
  if (b.law == BitLaw::fixed) {
    s.velocity = s.rotary_speed = 0.0;
    return;
  }
  Lost lost;
  const double v = s.velocity, omega = s.rotary_speed;
  double next_v = 0.0, next_omega = set_speed;
  if (b.directions != Directions::torsion) next_v = flow_down(b, time, load.pull, s, lost);
  if (b.directions != Directions::axial) {
    next_omega = flow_round(b, time, load.torque, s, lost);
  }
  const double way = time * 0.5 * (v + next_v), turn = time * 0.5 * (omega + next_omega);
  s.ledger.cut += cutting_force(b, s) * way;
  if (b.directions != Directions::axial) s.ledger.cut += b.torque * turn;
  s.ledger.friction += lost.friction;
  s.ledger.damping += lost.damping;
  s.ledger.loss += damper.pull * way - damper.torque * turn;
  if (b.law == BitLaw::regenerative && next_omega == 0.0 && s.depth > 0.0) {
    s.ledger.friction += 0.5 * b.mass * next_v * next_v;
    next_v = 0.0;  // a blade that does not rotate does not cut
  }
  s.velocity = next_v;
  s.rotary_speed = next_omega;
}

void drift_bit(const SimpleBit& b, double h, BitState& s) {
  const double way = h * s.velocity;
  s.displacement += way;
  s.angle += h * s.rotary_speed;
  s.ledger.gravity += b.gravity_force * way;
  find_depth(b, s);
}

EndLoad bit_load(const SimpleBit& b, const BitState& s, const EndLoad& string) {
  if (b.law == BitLaw::fixed) return {b.gravity_force - string.pull, string.torque};
  const double sliding = friction_torque(b, s);
  const double most = b.law == BitLaw::two_level ? b.resting_torque : sliding;
  const double friction = s.rotary_speed == 0.0 ? std::clamp(string.torque - b.torque, -most, most)
                                                : std::copysign(sliding, s.rotary_speed);
  return {cutting_force(b, s) + b.contact_force * s.contact + b.axial_damping * s.velocity,
          friction + b.torque + b.torsional_damping * s.rotary_speed};
}

double stored_energy(const SimpleBit& b, const BitState& s) {
  double twice = 0.0;
  if (b.directions != Directions::torsion) twice += b.mass * s.velocity * s.velocity;
  if (b.directions != Directions::axial) twice += b.inertia * s.rotary_speed * s.rotary_speed;
  return 0.5 * twice;
}

void step_bit_on_chain(const Chain& chain, const SimpleBit& bit, double h,
                       const TopCommand& command, BitOnChain& s, ChainWork& w) {
  open_step(chain, h, command, s.chain, w);
  flow_bit(bit, 0.5 * h, end_load(w), end_damper(w), s.chain.top.set_speed, s.bit);
  drift_bit(bit, h, s.bit);
  load_elements(chain, motion_of(s.bit), s.chain, w);
  close_step(chain, h, command, s.chain, w);
  flow_bit(bit, 0.5 * h, end_load(w), end_damper(w), s.chain.top.set_speed, s.bit);
}

double energy_balance(const Chain& chain, const SimpleBit& bit, const BitOnChain& s) {
  const ChainLedger& c = s.chain.ledger;
  const BitLedger& b = s.bit.ledger;
  return stored_energy(chain, s.chain, motion_of(s.bit)) + stored_energy(bit, s.bit) + c.friction +
         c.damping + c.loss + c.top_damping + b.cut + b.friction + b.damping + b.loss - c.top -
         c.gravity - b.gravity;
}

}  // namespace tdbd::string
