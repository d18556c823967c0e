#pragma once

#include "dynamics/drilling/drilling_step.hpp"
#include "string/statics.hpp"

namespace tdbd::dynamics {

/// @file
/// A distributed string above the springs at the bit. The flows of its nodes at resting positions
/// commute with those of the bit, with which they share positions alone, so that a step of both is
///   flow of nodes and bit over h/2, drift of both, loads of the elements, flow of both over h/2.
/// Every function does nothing where the system has no chain.

/// Flow and drift of the chain's own nodes, before those of the bit.
void open_chain(const DrillingSystem& system, double h, Drilling& d, DrillingWork& work);

/// After the bit's drift, before it is configured: the springs' upper end is at the last own node.
void place_upper_end(const DrillingSystem& system, const string::ChainState& chain,
                     UpperEnd& upper);

/// After the bit was configured: the loads of the elements, and the forces of Kelvin-Voigt's
/// dampers of the last one on the bit.
void load_chain(const DrillingSystem& system, double h, Drilling& d, DrillingWork& work);

/// The flow of the chain's own nodes that closes the step, and the ledger.
void close_chain(const DrillingSystem& system, double h, Drilling& d, DrillingWork& work);

/// The work of a chain at the positions of the bit, when no step is open.
void start_chain_work(const DrillingSystem& system, const Drilling& d, DrillingWork& work);

/// The motion of the chain's last node when no step is open: that of the bit's attachment along z, from its
/// slack place, and of the bit about z.
string::EndMotion end_motion(const DrillingSystem& system, const Drilling& d,
                             const DrillingWork& work);

/// A chain in steady motion above a bit that starts as `state` does, whose springs pull it up with `pull`
/// (N) and turn it with `torque` (N m). Sets the springs' slack place, and their upper end in `state`.
void start_chain(const string::SteadyMotion& motion, DrillingSystem& system, DrillingState& state,
                 string::ChainState& chain);

}  // namespace tdbd::dynamics
