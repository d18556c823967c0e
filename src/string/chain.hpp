#pragma once

#include <vector>

#include "string/section.hpp"
#include "string/side_force.hpp"
#include "string/top.hpp"

namespace tdbd::string {

/// Directions in which the nodes of a chain move.
enum class Directions {
  both,
  torsion,  ///< no tension: the side force comes from the weight only
  axial,    ///< rotates like its top; without friction
};

/// A drill string as a chain of nodes: 0 at the top, n at the bit, connected by n elements, string
/// (1) to (4). The last node does not belong to the chain; it is part of the bit.
struct Chain {
  Directions directions = Directions::both;
  Elements elements;
  Contact contact;
  double threshold = 0.0;            ///< slip below which static friction applies, m/s
  double axial_damping = 0.0;        ///< by the mud, proportional to mass, 1/s
  double torsional_damping = 0.0;    ///< by the mud, proportional to inertia, 1/s
  double axial_loss_time = 0.0;      ///< Kelvin-Voigt, s
  double torsional_loss_time = 0.0;  ///< Kelvin-Voigt, s
  Top top;

  int count() const { return static_cast<int>(elements.axial.size()); }
  bool has_loss() const { return axial_loss_time > 0.0 || torsional_loss_time > 0.0; }
};

/// Work and losses of the chain since the start, J. A loss of friction or dampers is minus their
/// impulse times the mean speed of their flow.
struct ChainLedger {
  double top = 0.0;          ///< work of the top on the string
  double gravity = 0.0;      ///< work of the weight
  double friction = 0.0;     ///< loss at the wall of the hole
  double damping = 0.0;      ///< loss in the mud
  double loss = 0.0;         ///< loss in the Kelvin-Voigt dampers at the chain's own nodes
  double top_damping = 0.0;  ///< loss in the damper of a top drive

  template <class Archive>
  void serialize(Archive& a) {
    a(top, gravity, friction, damping, loss, top_damping);
  }
};

/// Nodes 0 to n - 1 and the ledger: sufficient for a restart.
struct ChainState {
  std::vector<double> displacement;          ///< along the hole, downward, m
  std::vector<double> velocity;              ///< m/s
  std::vector<double> angle;                 ///< about the hole, positive as the bit rotates, rad
  std::vector<double> rotary_speed;          ///< rad/s
  std::vector<double> stretching, twisting;  ///< rates of elements in the last drift, m/s, rad/s
  TopState top;
  ChainLedger ledger;

  template <class Archive>
  void serialize(Archive& a) {
    a(displacement, velocity, angle, rotary_speed, stretching, twisting, top, ledger);
  }
};

/// The motion of the last node, at the end of the chain's last element.
struct EndMotion {
  double displacement = 0.0;  ///< m
  double angle = 0.0;         ///< rad
  double velocity = 0.0;      ///< in the last drift, m/s: only for the Kelvin-Voigt dampers
  double rotary_speed = 0.0;  ///< in the last drift, rad/s
};

/// The load of the last element on the last node.
struct EndLoad {
  double pull = 0.0;    ///< upward, N
  double torque = 0.0;  ///< positive as the top rotates, N m
};

/// Work data derived from a state, reused so that steps allocate nothing after the first.
struct ChainWork {
  std::vector<double> tension, torque;              ///< of elements, N, N m; including dampers
  std::vector<double> damper_force, damper_torque;  ///< Kelvin-Voigt parts of them
  std::vector<double> side_force;                   ///< of nodes, N
  std::vector<double> along, around;                ///< mobilities of half a step, slip units, s/kg
  std::vector<double> radius, inverse_radius;       ///< of the contact, m, 1/m
  std::vector<double> mass_around;                  ///< inertia over radius squared, kg
  std::vector<double> next_along, next_around;      ///< slips after a flow, m/s
  std::vector<double> margin;                       ///< negative if far from rest, m2/s2
  std::vector<double> before_velocity, before_speed;  ///< before a flow, m/s, rad/s
  double half_step = -1.0;                            ///< s, for which the mobilities were computed
  double opening_pull = 0.0, opening_torque = 0.0;    ///< of the first element before the drift
  double opening_behind = 0.0;  ///< angle by which the top lags the set point before the drift, rad
  double set_turn = 0.0;        ///< rotation of the set point in the drift, rad
  long resting = 0;             ///< number of nodes at rest after the last flow
};

/// Nodes at rest without load.
ChainState chain_at_rest(const Chain& chain);

/// Prepares the next step of a chain that was just started or restored.
ChainWork chain_work(const Chain& chain, const ChainState& state, const EndMotion& end);

/// First half of a step of h (s): the flow of all forces on nodes 0 to n - 1 over h/2, then their
/// drift, string (9).
void open_step(const Chain& chain, double h, const TopCommand& command, ChainState& state,
               ChainWork& work);

/// Computes tensions, torques and side forces at the positions after the drift. Call it between
/// open_step and close_step, after the drift of the bit.
void load_elements(const Chain& chain, const EndMotion& end, ChainState& state, ChainWork& work);

/// Load of the chain on the bit. Valid from one call of load_elements to the next.
inline EndLoad end_load(const ChainWork& work) { return {work.tension.back(), work.torque.back()}; }

/// The part of end_load from the Kelvin-Voigt dampers. The owner of the bit adds minus this times
/// the mean speed of its flow to its ledger: the energy that the dampers take there.
inline EndLoad end_damper(const ChainWork& work) {
  return {work.damper_force.back(), work.damper_torque.back()};
}

/// Second half of a step: the flow over h/2 at the new positions, and the ledger. `command` is that
/// of open_step; its `weight` is the set point of an autodriller.
void close_step(const Chain& chain, double h, const TopCommand& command, ChainState& state,
                ChainWork& work);

/// Stored energy, J: kinetic energy of the chain's own nodes, strain energy of all elements, the
/// spring of a top drive.
double stored_energy(const Chain& chain, const ChainState& state, const EndMotion& end);

/// Current hook load (N) and torque (N m) at the top of the string.
struct SurfaceLoad {
  double hook_load = 0.0;
  double torque = 0.0;
};
SurfaceLoad surface_load(const Chain& chain, const ChainState& state, const ChainWork& work);

/// The longest stable step, s: h omega < 2, where omega^2 is at most the largest 2 (k above + k
/// below)/m, and with Kelvin-Voigt dampers (h omega/2)^2 (1 + 2 tau/h) < 1, string (10). `end_mass`
/// and `end_inertia` are those of the last node including the bit; not positive if it cannot move.
double longest_step(const Chain& chain, double end_mass, double end_inertia);

}  // namespace tdbd::string
