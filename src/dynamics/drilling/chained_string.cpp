#include "dynamics/drilling/chained_string.hpp"

#include "dynamics/drilling/configuration.hpp"
#include "rotation/quaternion.hpp"

namespace tdbd::dynamics {
namespace {

/// Displacement of the attachment along z from its slack position, and rotation of the bit about z.
string::EndMotion end_of(const DrillingSystem& s, const DrillingState& state,
                         const Configuration& at) {
  string::EndMotion end;
  end.displacement = state.c_W.z() + at.pull.arm_W.z() - s.string.rest_W.z();
  end.angle = rotation::twist_angle(state.rotation.q_WB, state.rotation.turns);
  return end;
}

void copy_chain_ledger(const string::ChainLedger& chain, EnergyLedger& l) {
  l.top = chain.top;
  l.chain_gravity = chain.gravity;
  l.chain_friction = chain.friction;
  l.chain_damping = chain.damping;
  l.chain_loss = chain.loss;
  l.top_damping = chain.top_damping;
}

/// Energy without the last element, which is the spring at the bit.
double energy_of(const string::Chain& c, const string::ChainState& chain) {
  return string::stored_energy(
      c, chain, {.displacement = chain.displacement.back(), .angle = chain.angle.back()});
}

/// Adds the forces of the dampers of the last element to the forces on the bit.
void add_damper_forces(const string::EndLoad& damper, const DrillingState& state,
                       DrillingWork& work) {
  work.chain_damper.force_W = -damper.pull * Vec3::UnitZ();
  work.chain_damper.torque_W = work.at.pull.arm_W.cross(work.chain_damper.force_W) +
                               damper.torque * rotation::twist_gradient(state.rotation.q_WB);
  work.at.conservative.force_W += work.chain_damper.force_W;
  work.at.conservative.torque_W += work.chain_damper.torque_W;
}

}  // namespace

void open_chain(const DrillingSystem& s, double h, Drilling& d, DrillingWork& work) {
  if (!s.chained) return;
  const double t = d.state.rotation.time;
  const auto over_step = [&](const Schedule& rate) {
    return integral_to(rate, t + h) - integral_to(rate, t);
  };
  work.chain_start = d.chain;
  work.end_before = end_of(s, d.state, work.at);
  const Schedule& pull = s.chained->hook_load;
  const double hook_load =
      pull.values.size() > 1 ? over_step(pull) / h : value_at(pull, t);  // mean over the step
  work.command = {over_step(s.top.speed), over_step(s.top.rate), hook_load,
                  s.chained->surface_weight};
  string::open_step(s.chained->chain, h, work.command, d.chain, work.chain);
  d.state.upper.rate = d.chain.velocity.back();
  d.state.upper.speed = d.chain.rotary_speed.back();
}

void place_upper_end(const DrillingSystem& s, const string::ChainState& chain, UpperEnd& upper) {
  if (!s.chained) return;
  upper.z = chain.displacement.back();
  upper.angle = chain.angle.back();
}

void load_chain(const DrillingSystem& s, double h, Drilling& d, DrillingWork& work) {
  if (!s.chained) return;
  string::EndMotion end = end_of(s, d.state, work.at);
  end.velocity = (end.displacement - work.end_before.displacement) / h;
  end.rotary_speed = (end.angle - work.end_before.angle) / h;
  string::load_elements(s.chained->chain, end, d.chain, work.chain);
  add_damper_forces(string::end_damper(work.chain), d.state, work);
}

void close_chain(const DrillingSystem& s, double h, Drilling& d, DrillingWork& work) {
  if (!s.chained) return;
  string::close_step(s.chained->chain, h, work.command, d.chain, work.chain);
  copy_chain_ledger(d.chain.ledger, d.ledger);
  work.at.chain_energy = energy_of(s.chained->chain, d.chain);
}

void start_chain_work(const DrillingSystem& s, const Drilling& d, DrillingWork& work) {
  if (!s.chained) return;
  work.chain = string::chain_work(s.chained->chain, d.chain, end_of(s, d.state, work.at));
  add_damper_forces(string::end_damper(work.chain), d.state, work);
  work.at.chain_energy = energy_of(s.chained->chain, d.chain);
}

string::EndMotion end_motion(const DrillingSystem& s, const Drilling& d, const DrillingWork& work) {
  string::EndMotion end = end_of(s, d.state, work.at);
  const DrillingVelocity v = velocity(s, d.state);
  end.velocity = point_velocity(v, work.at.pull.arm_W).z();
  end.rotary_speed = rotation::twist_gradient(d.state.rotation.q_WB).dot(v.w_W);
  return end;
}

void start_chain(const string::SteadyMotion& motion, DrillingSystem& s, DrillingState& state,
                 string::ChainState& chain) {
  const string::Chain& c = s.chained->chain;
  string::SteadyStart start = string::steady_start(c, motion, string::steady_load(c, motion));
  chain = std::move(start.chain);
  // Shifts all angles so that the angle of the bit is 0 and the string above it is wound up.
  for (double& angle : chain.angle) angle -= start.end.angle;
  chain.top.set_angle -= start.end.angle;
  const Vec3 attachment = state.c_W + state.rotation.q_WB * (s.string.attachment_B - s.centre_B);
  s.string.rest_W.z() = attachment.z() - start.end.displacement;
  place_upper_end(s, chain, state.upper);
}

}  // namespace tdbd::dynamics
