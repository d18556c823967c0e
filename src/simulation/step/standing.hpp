#pragma once

#include "simulation/case/case.hpp"
#include "simulation/step/implicit_loads.hpp"

namespace tdbd::simulation {

struct Move;
struct State;
struct Work;

/// What a step did about a bit that stands.
struct Standing {
  double steepness = 0.0;  ///< of the laws beside what the step gives way; up to 1: a bound of it
  bool stands = false;     ///< the impulse was implicit
  Search search;
};

/// Kept from step to step.
struct StandingWork {
  dynamics::Response response;
  dynamics::ResponseWork responding;
  BitVelocity last_drift;  ///< over the rock
  ImplicitWork implicit;
};

/// Steps in which the bit stood, for the summary.
struct StandingStatistics {
  long steps = 0;
  long unsettled = 0;  ///< whose search did not settle: implicit at the last secants
  long most_rounds = 0;
};

void add(const Standing& step, StandingStatistics& statistics);

/// A bit that stands, simulation (7), (8) (ours). At rest the slope of a law over the velocity is so steep that
/// an explicit impulse would overshoot in every step, and the weight dither by its own size. So
/// where the laws are too steep for the step (steepness above 1 at the velocity of the last drift), loads and
/// velocity are those at the velocity that the next drift will have. Elsewhere `work.loads` stay untouched and
/// the step is explicit. Sets work.standing; if it stands, work.loads and work.velocity.
void stand(const Case& c, const Move& move, const State& state, Work& work);

/// Finds the forces with which a run starts where parts that press touch the rock: those of the
/// opening kick, at the velocity that the first drift will have. Without them the bit would fall
/// freely during the first step.
void bear_at_start(const Case& c, State& state, Work& work);

}  // namespace tdbd::simulation
