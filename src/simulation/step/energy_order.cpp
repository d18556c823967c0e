#include "simulation/step/energy_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "rock/maintain/touched_region.hpp"

namespace tdbd::simulation {
namespace {

/// Steps of h that all levels take together.
constexpr long cost_per_step = (1L << dynamics::residual_levels) - 1;

/// The observation takes at most one step per this many steps of the run.
constexpr long least_steps_per_cost = 10;

/// The case with every step divided into `parts`; no step is included in means.
Case divided(Case c, int parts) {
  c.time.step /= parts;
  c.time.steps *= parts;
  c.time.first *= parts;
  c.maintenance.every *= parts;
  c.maintenance.rest *= parts;
  c.maintenance.longest_wait *= parts;
  c.maintenance.renumber_every *= parts;
  c.output.means_from = std::numeric_limits<double>::infinity();
  return c;
}

/// The simulation at the start of the window with a new ledger, so that its rounding is that of the
/// window only.
Simulation at_window(const Case& finer, const Simulation& s, int parts) {
  State state = s.state;
  state.steps_done *= parts;
  rock::scale_cut_counts(state.rock, parts);
  const dynamics::DrillingState& now = s.state.drive->state;
  state.drive->ledger = {};
  state.drive->chain.ledger = {};
  state.drive->ledger.start =
      dynamics::total(dynamics::stored_energy(finer.drilling.system, s.work.drive.at, now));
  return resume(finer, std::move(state), start_statistics(finer));
}

struct Windows {
  const Case& c;
  const Simulation& s;
  bool contact = true;  ///< at every instant of every level so far

  dynamics::WindowResiduals drilled(int parts) {
    const Case finer = divided(c, parts);
    Simulation copy = at_window(finer, s, parts);
    dynamics::WindowResiduals w;
    w.at_instants.reserve(static_cast<std::size_t>(c.output.energy_order_window));
    for (long i = 0; i < c.output.energy_order_window; ++i) {
      for (int k = 0; k < parts; ++k) step(finer, copy);
      contact = contact && !copy.work.cuts.empty();
      w.at_instants.push_back(dynamics::residual(
          dynamics::stored_energy(c.drilling.system, copy.work.drive.at, copy.state.drive->state),
          copy.state.drive->ledger));
    }
    w.scale = dynamics::throughput(copy.state.drive->ledger);
    return w;
  }
};

}  // namespace

EnergyOrderPlan plan_energy_order(const Case& c) {
  if (c.motion.kind != MotionKind::drilling || c.output.energy_order == EnergyOrderOption::off)
    return {-1, "output.energy_order is off"};
  if (wears(c.wear)) return {-1, "the bit wears"};
  const long window = c.output.energy_order_window, last = c.time.steps - window;
  const long least = least_steps_per_cost * cost_per_step * window;
  if (c.output.energy_order == EnergyOrderOption::on && c.time.steps < least)
    return {-1, fmt::format("{} steps, of a run of {}, are more than a tenth: it needs {} steps, "
                            "or output.energy_order = \"always\"",
                            cost_per_step * window, c.time.steps, least)};
  if (last < 0)
    return {-1, fmt::format("a window of {} steps does not fit into {}", window, c.time.steps)};
  const long every = std::max(c.maintenance.every, 1L);
  const double from = std::ceil(c.output.means_from / c.time.step);
  const long wanted = static_cast<long>(std::min(from, static_cast<double>(last)));
  return {std::min((wanted + every - 1) / every * every, last / every * every), ""};
}

EnergyOrder observe_energy_order(const Case& c, const Simulation& s) {
  EnergyOrder found;
  found.from = c.time.step * static_cast<double>(s.state.steps_done);
  found.window = c.time.step * static_cast<double>(c.output.energy_order_window);
  Windows windows{c, s};
  try {
    found.residual = dynamics::residual_order(
        c.time.step, [&windows](int parts) { return windows.drilled(parts); });
  } catch (const RunError& e) {
    found.residual.reason = fmt::format("the window fails with a finer step: {}", e.what());
  }
  if (!windows.contact) {
    found.residual.order.reset();
    found.residual.reason = "the bit loses contact with the rock in the window";
  }
  return found;
}

}  // namespace tdbd::simulation
