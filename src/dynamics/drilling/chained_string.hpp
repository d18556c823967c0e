#pragma once

#include "dynamics/drilling/drilling_step.hpp"
#include "string/statics.hpp"

namespace tdbd::dynamics {

/// @file
/// A distributed string above the springs at the bit. The nodes and the bit share only positions,
/// so their flows at fixed positions commute. A step of both is
///   flow of nodes and bit over h/2, drift of both, loads of the elements, flow of both over h/2.
/// All functions do nothing if the system has no chain.

/// First half of a step: flow and drift of the chain's own nodes. Call it before those of the bit.
void open_chain(const DrillingSystem& system, double h, Drilling& d, DrillingWork& work);

/// Moves the upper end of the springs to the last own node. Call it after the drift of the bit,
/// before `configure`.
void place_upper_end(const DrillingSystem& system, const string::ChainState& chain,
                     UpperEnd& upper);

/// Computes the loads of the elements, and the forces on the bit of the Kelvin-Voigt dampers of the
/// last element. Call it after `configure`.
void load_chain(const DrillingSystem& system, double h, Drilling& d, DrillingWork& work);

/// Second half of a step: flow of the chain's own nodes, and the ledger.
void close_chain(const DrillingSystem& system, double h, Drilling& d, DrillingWork& work);

/// Initializes the chain's work data at the position of the bit. Requires that no step is open.
void start_chain_work(const DrillingSystem& system, const Drilling& d, DrillingWork& work);

/// Motion of the last node of the chain: displacement of the attachment of the bit along z from its
/// slack position, rotation of the bit about z, and their rates. Requires that no step is open.
string::EndMotion end_motion(const DrillingSystem& system, const Drilling& d,
                             const DrillingWork& work);

/// Starts a chain in steady motion above a bit in state `state`. The springs of the bit pull it up
/// with the `pull` (N) and turn it with the `torque` (N m) of the motion. Sets the slack position
/// of the springs in `system`, and their upper end in `state`.
void start_chain(const string::SteadyMotion& motion, DrillingSystem& system, DrillingState& state,
                 string::ChainState& chain);

}  // namespace tdbd::dynamics
