#pragma once

#include <vector>

#include "string/section.hpp"
#include "string/side_force.hpp"
#include "string/top.hpp"

namespace tdbd::string {

/// In which directions the nodes of a chain move.
enum class Directions {
  both,
  torsion,  ///< no tension: the side force is that of the weight alone
  axial,    ///< turns as its top does; without friction
};

/// A drill string as a chain of nodes: 0 at the top, n at the bit, joined by n elements, string (1)
/// to (4). The last node is not the chain's own: what holds it is a bit.
struct Chain {
  Directions directions = Directions::both;
  Elements elements;
  Contact contact;
  double threshold = 0.0;            ///< slip below which friction is that at rest, m/s
  double axial_damping = 0.0;        ///< of the mud, by mass, 1/s
  double torsional_damping = 0.0;    ///< of the mud, by inertia, 1/s
  double axial_loss_time = 0.0;      ///< Kelvin-Voigt, s
  double torsional_loss_time = 0.0;  ///< Kelvin-Voigt, s
  Top top;

  int count() const { return static_cast<int>(elements.axial.size()); }
  bool has_loss() const { return axial_loss_time > 0.0 || torsional_loss_time > 0.0; }
};

/// Where energy of the chain came from and went to since the start, J. What friction and dampers
/// take is minus their impulse times the mean speed of their flow.
struct ChainLedger {
  double top = 0.0;          ///< done by the top on the string
  double gravity = 0.0;      ///< done by the weight
  double friction = 0.0;     ///< taken by the wall of the hole
  double damping = 0.0;      ///< by the mud
  double loss = 0.0;         ///< by Kelvin-Voigt's dampers at the chain's own nodes
  double top_damping = 0.0;  ///< by the damper of a top drive
};

/// Nodes 0 to n - 1 as a restart needs them, and the ledger.
struct ChainState {
  std::vector<double> displacement;          ///< along the hole, downward, m
  std::vector<double> velocity;              ///< m/s
  std::vector<double> angle;                 ///< about the hole, as the bit turns, rad
  std::vector<double> rotary_speed;          ///< rad/s
  std::vector<double> stretching, twisting;  ///< rates of elements in the last drift, m/s, rad/s
  TopState top;
  ChainLedger ledger;
};

/// The motion of the last node, which the chain's last element ends at.
struct EndMotion {
  double displacement = 0.0;  ///< m
  double angle = 0.0;         ///< rad
  double velocity = 0.0;      ///< in the last drift, m/s: for Kelvin-Voigt's dampers alone
  double rotary_speed = 0.0;  ///< in the last drift, rad/s
};

/// What the last element does to the last node.
struct EndLoad {
  double pull = 0.0;    ///< upward, N
  double torque = 0.0;  ///< as the top turns, N m
};

/// What follows from a state, kept beside it so that a step allocates nothing once warm.
struct ChainWork {
  std::vector<double> tension, torque;              ///< of elements, N, N m; with dampers
  std::vector<double> damper_force, damper_torque;  ///< Kelvin-Voigt's share of them
  std::vector<double> side_force;                   ///< of nodes, N
  std::vector<double> along, around;                ///< mobilities of half a step, slip units, s/kg
  std::vector<double> radius, inverse_radius;       ///< of the contact, m, 1/m
  std::vector<double> mass_around;                  ///< inertia over radius squared, kg
  std::vector<double> next_along, next_around;      ///< slips after a flow, m/s
  std::vector<double> margin;                       ///< negative: far from rest, m2/s2
  std::vector<double> before_velocity, before_speed;  ///< before a flow, m/s, rad/s
  double half_step = -1.0;                            ///< s, that the mobilities are of
  double opening_pull = 0.0, opening_torque = 0.0;    ///< of the first element before the drift
  double opening_behind = 0.0;  ///< angle of the set point ahead of the top before the drift, rad
  double set_turn = 0.0;        ///< of the set point in the drift, rad
  long resting = 0;             ///< nodes at rest after the last flow
};

/// Nodes that hang unloaded and at rest.
ChainState chain_at_rest(const Chain& chain);

/// Ready for the next step of what was just started or restored.
ChainWork chain_work(const Chain& chain, const ChainState& state, const EndMotion& end);

/// First half of a step of h (s): the flow of all forces on nodes 0 to n - 1 over h/2, then their
/// drift, string (9).
void open_step(const Chain& chain, double h, const TopCommand& command, ChainState& state,
               ChainWork& work);

/// Tensions, torques and side forces at the positions after the drift. Call it between open_step
/// and close_step, after the bit has drifted.
void load_elements(const Chain& chain, const EndMotion& end, ChainState& state, ChainWork& work);

/// Load of the chain on the bit from load_elements until the next one.
inline EndLoad end_load(const ChainWork& work) { return {work.tension.back(), work.torque.back()}; }

/// The part of it that Kelvin-Voigt's dampers have. The owner of the bit books minus this times the
/// mean speed of its flow, the energy that they take there.
inline EndLoad end_damper(const ChainWork& work) {
  return {work.damper_force.back(), work.damper_torque.back()};
}

/// Second half: the flow over h/2 at the new positions, and the ledger. `weight`: what an
/// autodriller is to keep, from the command of this step.
void close_step(const Chain& chain, double h, const TopCommand& command, ChainState& state,
                ChainWork& work);

/// What is stored, J: kinetic energy of the chain's own nodes, strain of all elements, the spring of
/// a top drive.
double stored_energy(const Chain& chain, const ChainState& state, const EndMotion& end);

/// Hook load (N) and torque (N m) that the top of the string needs now.
struct SurfaceLoad {
  double hook_load = 0.0;
  double torque = 0.0;
};
SurfaceLoad surface_load(const Chain& chain, const ChainState& state, const ChainWork& work);

/// The longest stable step, s: h omega < 2, omega^2 at most the largest 2 (k above + k below)/m, and
/// with Kelvin-Voigt's dampers (h omega/2)^2 (1 + 2 tau/h) < 1, string (10). `end_mass`,
/// `end_inertia`: of the last node with its bit; not positive where that cannot move.
double longest_step(const Chain& chain, double end_mass, double end_inertia);

}  // namespace tdbd::string
