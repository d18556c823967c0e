#pragma once

#include "simulation/case/case.hpp"
#include "simulation/step/implicit_loads.hpp"

namespace tdbd::simulation {

struct Move;
struct State;
struct Work;

/// Result of the implicit solution of a step.
struct Standing {
  double steepness = 0.0;  ///< of the laws relative to the compliance of the step; up to 1, a bound
  bool stands = false;     ///< whether the impulse was implicit
  Search search;
};

/// Work data, reused between steps.
struct StandingWork {
  dynamics::Response response;
  dynamics::ResponseWork responding;
  BitVelocity last_drift;  ///< relative to the rock
  ImplicitWork implicit;
};

/// Statistics of the implicit steps, for the summary.
struct StandingStatistics {
  long steps = 0;
  long unsettled = 0;  ///< steps whose search did not converge: implicit with the last secants
  long most_rounds = 0;
};

void add(const Standing& step, StandingStatistics& statistics);

/// Computes the loads of a bit at rest or nearly at rest implicitly, simulation (7), (8). An
/// addition of TDBD [+]. At rest the slope of a law over velocity is so steep that an explicit
/// impulse would overshoot in every step, and the weight on bit would oscillate with an amplitude
/// of its own size. If the steepness at the velocity of the last drift exceeds 1, loads and
/// velocity are those at the velocity of the next drift. Otherwise `work.loads` is unchanged and
/// the step is explicit. Sets work.standing, and if the step is implicit also work.loads and
/// work.velocity.
void stand(const Case& c, const Move& move, const State& state, Work& work);

/// Computes the initial forces if pressing parts touch the rock at the start: those of the opening
/// kick, at the velocity of the first drift. Without them the bit would fall freely during the
/// first step.
void bear_at_start(const Case& c, State& state, Work& work);

}  // namespace tdbd::simulation
