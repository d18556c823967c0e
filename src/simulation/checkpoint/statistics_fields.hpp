#pragma once

#include "simulation/checkpoint/tape_items.hpp"
#include "simulation/step/energy_order.hpp"
#include "simulation/step/simulation.hpp"

// The members of Statistics, in the order in which a checkpoint holds them.

namespace tdbd::simulation {

template <class A>
void fields(A& a, Of<A, Spread>& x) {
  a("count", x.count);
  a("mean", x.mean);
  a("squares", x.squares);
}

template <class A>
void fields(A& a, Of<A, FaceSpreads>& x) {
  a("area", x.area);
  a("swept", x.swept);
  a("removed", x.removed);
}

template <class A>
void fields(A& a, Of<A, FaceStatistics>& x) {
  a("revolution", x.revolution);
  a("last_whole", x.last_whole);
  a("revolutions", x.revolutions);
  a("refused_deep", x.refused_deep);
  a("refused_over_the_top", x.refused_over_the_top);
}

template <class A>
void fields(A& a, Of<A, ConeStatistics>& x) {
  a("bit_turned", x.bit_turned);
  a("ratio", x.ratio);
  a("least", x.least);
  a("greatest", x.greatest);
}

template <class A>
void fields(A& a, Of<A, LoadStatistics>& x) {
  a("wob", x.wob);
  a("tob", x.tob);
  a("rop", x.rop);
  a("rotary_speed", x.rotary_speed);
  a("lateral_B", x.lateral_B);
  a("energy", x.energy);
  a("removed", x.removed);
  a("time", x.time);
  a("normal", x.normal);
  a("tangential", x.tangential);
  a("part_energy", x.part_energy);
  a("part_removed", x.part_removed);
}

template <class A>
void fields(A& a, Of<A, Trace>& x) {
  a("dt", x.dt);
  a("wob", x.wob);
  a("tob", x.tob);
  a("rop", x.rop);
  a("rotary_speed", x.rotary_speed);
  a("centre_W", x.centre_W);
}

template <class A>
void fields(A& a, Of<A, StandingStatistics>& x) {
  a("steps", x.steps);
  a("unsettled", x.unsettled);
  a("most_rounds", x.most_rounds);
}

template <class A>
void fields(A& a, Of<A, WearRecord>& x) {
  a("distance", x.distance);
  a("weight", x.weight);
  a("torque", x.torque);
  a("rate", x.rate);
  a("height", x.height);
  a("width", x.width);
  a("volume", x.volume);
  a("temperature", x.temperature);
  a("force", x.force);
}

template <class A>
void fields(A& a, Of<A, WearRecords>& x) {
  a("every", x.every);
  a("seen", x.seen);
  a("records", x.records);
}

template <class A>
void fields(A& a, Of<A, Statistics>& x) {
  a("faces", x.faces);
  a("cones", x.cones);
  a("loads", x.loads);
  a("energy_by_part", x.energy_by_part);
  a("trace", x.trace);
  a("standing", x.standing);
  a("wear", x.wear);
  a("node_steps_at_rest", x.node_steps_at_rest);
}

template <class A>
void fields(A& a, Of<A, dynamics::ResidualOrder>& x) {
  a("order", x.order);
  a("reason", x.reason);
  a("steps", x.steps);
  a("residuals", x.residuals);
}

template <class A>
void fields(A& a, Of<A, EnergyOrder>& x) {
  a("residual", x.residual);
  a("from", x.from);
  a("window", x.window);
}

}  // namespace tdbd::simulation
