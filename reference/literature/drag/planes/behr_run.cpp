#include <numeric>

#include "reference/literature/drag/drag_input.hpp"
#include "reference/literature/drag/planes/behr.hpp"

namespace tdbd::reference {
namespace {

BehrRun empty_run(const BehrState& state, double dt, std::size_t steps, const DragRock& rock) {
  require_positive("Behr et al.", "time step (s)", dt);
  require_positive("Behr et al.", "specific energy of the rock (Pa)", rock.specific_energy);
  BehrRun run;
  run.dt = dt;
  run.cutters.resize(state.rims.size());
  run.weight.reserve(steps);
  run.torque.reserve(steps);
  run.lateral_W.reserve(steps);
  run.volume.reserve(steps);
  return run;
}

void add_step(BehrRun& run, const BehrLoad& load) {
  run.weight.push_back(load.weight);
  run.torque.push_back(load.torque);
  run.lateral_W.push_back(load.lateral_W);
  run.volume.push_back(load.volume);
  for (std::size_t i = 0; i < run.cutters.size(); ++i) {
    BehrCutter& sum = run.cutters[i];
    const BehrCutter& own = load.cutters[i];
    sum.force_W += own.force_W;
    sum.force.cutting += own.force.cutting;
    sum.force.normal += own.force.normal;
    sum.area += own.area;
    sum.volume += own.volume;
    sum.rubbed_volume += own.rubbed_volume;
    sum.crossings += own.crossings;
    sum.backward_crossings += own.backward_crossings;
  }
}

/// Divides the sums of forces by the number of steps.
BehrRun finished(BehrRun run) {
  const double steps = static_cast<double>(run.weight.size());
  for (BehrCutter& c : run.cutters) {
    c.force_W /= steps;
    c.force.cutting /= steps;
    c.force.normal /= steps;
  }
  return run;
}

}  // namespace

double BehrRun::mean_area(std::size_t cutter) const {
  const BehrCutter& c = cutters[cutter];
  return c.crossings > 0 ? c.area / c.crossings : 0.0;
}

double BehrRun::removed() const { return std::accumulate(volume.begin(), volume.end(), 0.0); }

double BehrRun::backward_share() const {
  long all = 0, backward = 0;
  for (const BehrCutter& c : cutters) {
    all += c.crossings;
    backward += c.backward_crossings;
  }
  return all > 0 ? static_cast<double>(backward) / static_cast<double>(all) : 0.0;
}

BehrRun behr_run(BehrState& state, const BitPath& path, double from, double dt, int steps,
                 const DragRock& rock, const BehrOptions& options) {
  require_positive("Behr et al.", "steps", steps);
  BehrRun run = empty_run(state, dt, at(steps), rock);
  BehrLoad load;
  for (int k = 1; k <= steps; ++k) {
    behr_step(state, path, from + (k - 1) * dt, dt, rock, options, load);
    add_step(run, load);
  }
  return finished(run);
}

BehrRun behr_run(BehrState& state, const std::vector<BitPlace>& places, double dt,
                 const DragRock& rock, const BehrOptions& options) {
  require_positive("Behr et al.", "steps", static_cast<double>(places.size()) - 1.0);
  BehrRun run = empty_run(state, dt, places.size() - 1, rock);
  BehrLoad load;
  for (std::size_t k = 1; k < places.size(); ++k) {
    behr_step(state, places[k], dt, rock, options, load);
    add_step(run, load);
  }
  return finished(run);
}

}  // namespace tdbd::reference
