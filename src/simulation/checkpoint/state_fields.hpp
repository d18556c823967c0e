#pragma once

#include "simulation/checkpoint/rock_fields.hpp"
#include "simulation/checkpoint/rotation_fields.hpp"
#include "simulation/step/simulation.hpp"

// The members of State, in the order in which a checkpoint holds them. A new member is a new line
// here; without it Checkpoints.go_on_to_the_bit fails as soon as a later step reads the member.

namespace tdbd::simulation {

template <class A>
void fields(A& a, Of<A, CompensatedSum>& x) {
  a("sum", x.sum);
  a("correction", x.correction);
}

template <class A>
void fields(A& a, Of<A, Pose>& x) {
  a("R", x.R);
  a("p", x.p);
}

template <class A>
void fields(A& a, Of<A, Place>& x) {
  a("X_WB", x.X_WB);
  a("turned", x.turned);
  a("rock_z", x.rock_z);
}

template <class A>
void fields(A& a, Of<A, bit::SlipBalance>& x) {
  a("moment", x.moment);
  a("inertia", x.inertia);
}

template <class A>
void fields(A& a, Of<A, ConeState>& x) {
  a("angle", x.angle);
  a("turned", x.turned);
  a("speed", x.speed);
  a("remembered", x.remembered);
  a("start_share", x.start_share);
}

template <class A>
void fields(A& a, Of<A, rock::Section>& x) {
  a("area", x.area);
  a("centroid_B", x.centroid_B);
  a("engaged_edge", x.engaged_edge);
  a("angle_of_attack", x.angle_of_attack);
  a("volume_rate", x.volume_rate);
  a("sight", x.sight);
  a("edge_centroid_B", x.edge_centroid_B);
  a("flat_area", x.flat_area);
  a("flat_centroid_B", x.flat_centroid_B);
}

template <class A>
void fields(A& a, Of<A, rotation::Twist>& x) {
  a("angular_B", x.angular_B);
  a("linear_B", x.linear_B);
}

template <class A>
void fields(A& a, Of<A, FacePath>& x) {
  a("way", x.way);
  a("creeps", x.creeps);
}

template <class A>
void fields(A& a, Of<A, rock::CutReport>& x) {
  a("removed_by_part", x.removed_by_part);
  a("removed", x.removed);
  a("candidates", x.candidates);
  a("moved", x.moved);
  a("passes", x.passes);
}

template <class A>
void fields(A& a, Of<A, dynamics::UpperEnd>& x) {
  a("z", x.z);
  a("angle", x.angle);
  a("rate", x.rate);
  a("speed", x.speed);
}

template <class A>
void fields(A& a, Of<A, dynamics::DrillingState>& x) {
  a("rotation", x.rotation);
  a("c_W", x.c_W);
  a("momentum_W", x.momentum_W);
  a("rock_z", x.rock_z);
  a("rock_momentum", x.rock_momentum);
  a("top_rate", x.top_rate);
  a("upper", x.upper);
}

template <class A>
void fields(A& a, Of<A, dynamics::Wrench>& x) {
  a("force_W", x.force_W);
  a("torque_W", x.torque_W);
  a("cones", x.cones);
  a("rock_force", x.rock_force);
  a("cone_impulse", x.cone_impulse);
}

template <class A>
void fields(A& a, Of<A, dynamics::EnergyLedger>& x) {
  a("start", x.start);
  a("top", x.top);
  a("gravity", x.gravity);
  a("cut_bit", x.cut_bit);
  a("cut_rock", x.cut_rock);
  a("damped_string", x.damped_string);
  a("damped_bearings", x.damped_bearings);
  a("damped_rock", x.damped_rock);
  a("wall_loss", x.wall_loss);
  a("wall_friction", x.wall_friction);
  a("chain_gravity", x.chain_gravity);
  a("chain_friction", x.chain_friction);
  a("chain_damping", x.chain_damping);
  a("chain_loss", x.chain_loss);
  a("top_damping", x.top_damping);
}

template <class A>
void fields(A& a, Of<A, string::TopState>& x) {
  a("set_angle", x.set_angle);
  a("set_speed", x.set_speed);
  a("rate", x.rate);
  a("hook_load", x.hook_load);
  a("error_integral", x.error_integral);
  a("measured", x.measured);
  a("limited", x.limited);
}

template <class A>
void fields(A& a, Of<A, string::ChainLedger>& x) {
  a("top", x.top);
  a("gravity", x.gravity);
  a("friction", x.friction);
  a("damping", x.damping);
  a("loss", x.loss);
  a("top_damping", x.top_damping);
}

template <class A>
void fields(A& a, Of<A, string::ChainState>& x) {
  a("displacement", x.displacement);
  a("velocity", x.velocity);
  a("angle", x.angle);
  a("rotary_speed", x.rotary_speed);
  a("stretching", x.stretching);
  a("twisting", x.twisting);
  a("top", x.top);
  a("ledger", x.ledger);
}

template <class A>
void fields(A& a, Of<A, dynamics::Drilling>& x) {
  a("state", x.state);
  a("wrench", x.wrench);
  a("ledger", x.ledger);
  a("chain", x.chain);
}

template <class A>
void fields(A& a, Of<A, VolumeLedger>& x) {
  a("hole_start", x.hole_start);
  a("removed", x.removed);
  a("trimmed", x.trimmed);
  a("removed_by_part", x.removed_by_part);
  a("removed_by_revolution", x.removed_by_revolution);
}

template <class A>
void fields(A& a, Of<A, rock::MaintenanceReport>& x) {
  a("done", x.done);
  a("refused", x.refused);
  a("touched_triangles", x.touched_triangles);
  a("volume_change", x.volume_change);
  a("volume_disturbed", x.volume_disturbed);
}

template <class A>
void fields(A& a, Of<A, Trimming>& x) {
  a("done_W", x.done_W);
  a("triangles", x.triangles);
}

template <class A>
void fields(A& a, Of<A, WornOff>& x) {
  a("volume", x.volume);
  a("height", x.height);
}

template <class A>
void fields(A& a, Of<A, PieceWear>& x) {
  a("volume", x.volume);
  a("height", x.height);
  a("window", x.window);
  a("previous", x.previous);
  a("last", x.last);
}

template <class A>
void fields(A& a, Of<A, PieceRub>& x) {
  a("force", x.force);
  a("temperature", x.temperature);
  a("rate", x.rate);
  a("flat_rate", x.flat_rate);
}

template <class A>
void fields(A& a, Of<A, WearState>& x) {
  a("pieces", x.pieces);
  a("rubs", x.rubs);
  a("window_time", x.window_time);
  a("previous_time", x.previous_time);
  a("window_steps", x.window_steps);
  a("window_distance", x.window_distance);
  a("window_weight", x.window_weight);
  a("window_torque", x.window_torque);
  a("distance", x.distance);
  a("steps", x.steps);
}

template <class A>
void fields(A& a, Of<A, SpallingState>& x) {
  a("ends", x.ends);
  a("broken_out", x.broken_out);
}

template <class A>
void fields(A& a, Of<A, State>& x) {
  a("steps_done", x.steps_done);
  a("place", x.place);
  a("start_turned", x.start_turned);
  a("rock", x.rock);
  a("start_triangles", x.start_triangles);
  a("cones", x.cones);
  a("sections", x.sections);
  a("face_paths", x.face_paths);
  a("cut", x.cut);
  a("drive", x.drive);
  a("ledger", x.ledger);
  a("maintenance", x.maintenance);
  a("trimming", x.trimming);
  a("started", x.started);
  a("wear", x.wear);
  a("spalling", x.spalling);
}

}  // namespace tdbd::simulation
