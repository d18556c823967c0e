#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>

#include "python/src/watch.hpp"
#include "simulation/rotate/rotate_simulation.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::python {

/// A simulation owned by a Python user, with its case. Only one thread at a time may use it. The
/// mutex is recursive because a function called during a step (progress, a signal handler) may read
/// the simulation.
template <class Case, class State>
struct Live {
  std::shared_ptr<const Case> of;
  State state;
  int threads = 1;
  std::unique_ptr<std::recursive_mutex> busy = std::make_unique<std::recursive_mutex>();
};

/// Calls look(state) without the GIL, while no other thread uses the simulation.
template <class Live, class Look>
auto read_state(Live& live, Look&& look) {
  const py::gil_scoped_release released;
  const std::lock_guard lock(*live.busy);
  return look(live.state);
}

inline long steps_done(const simulation::Simulation& s) { return s.state.steps_done; }
inline long steps_done(const simulation::RotateSimulation& s) { return s.steps_done; }

/// Throws ValueError if `steps` is negative.
inline long checked_steps(long steps) {
  if (steps < 0) throw py::value_error(fmt::format("steps: found {}, expected 0 or more", steps));
  return steps;
}

/// Performs `steps` steps, at most to the end of the case, in blocks: advance(state, steps). Checks
/// for progress and interruption after each block. Returns the number of steps performed.
template <class Live, class Advance>
long make_steps(Live& live, long steps, long block, const py::object& progress, Advance&& advance) {
  Watch watch(progress);
  long made = 0;
  {
    const py::gil_scoped_release released;
    const std::lock_guard lock(*live.busy);
    const long wanted = std::min(steps, live.of->time.steps - steps_done(live.state));
    while (made < wanted && !watch.interrupted()) {
      const long now = std::min(block, wanted - made);
      advance(live.state, now);
      made += now;
      watch.look(made, wanted);
    }
  }
  watch.rethrow();
  return made;
}

}  // namespace tdbd::python
