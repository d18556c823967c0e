// Wall time of the phases of a step on one and on two threads:
//   build/bench/benchmarks/phases standard-1.0 drill-bit-b
// Two copies of one drilling alternate in turns of 100 steps, so that both run under the same
// conditions. At the end their rocks and that of a third copy, drilled by simulation::step, must be
// bitwise identical.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "benchmarks/command.hpp"
#include "benchmarks/workloads.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "simulation/step/step.hpp"

namespace tdbd::bench {
namespace {

constexpr std::array<const char*, 5> phase_names = {"motion", "cut", "sections and contact",
                                                    "forces", "maintenance"};
/// Seconds by phase.
using PhaseTimes = std::array<double, phase_names.size()>;

struct Options {
  std::vector<std::string> workloads = {"standard-1.0", "standard-0.7", "drill-bit-b",
                                        "drill-bit-r", "drill-bit-b-whirl"};
  long turns = 10;
  int threads = 2;
  std::string json;
};

constexpr long steps_of_a_turn = 100;

/// One step, as in simulation::step for a case without wear, breakouts and parts that start late.
void timed_step(const simulation::Case& c, simulation::Simulation& s, PhaseTimes& times) {
  double before = wall_seconds();
  const auto lap = [&](std::size_t phase) {
    const double now = wall_seconds();
    times[phase] += now - before;
    before = now;
  };
  const simulation::Move move = simulation::drift(c, s.state, s.work);
  lap(0);
  simulation::cut(move, s.state, s.work);
  lap(1);
  simulation::measure(c, move, s.state, s.work);
  lap(2);
  simulation::apply_forces(c, move, s.state, s.work);
  simulation::kick(c, move, s.state, s.work);
  simulation::record(c, move, s);
  lap(3);
  ++s.state.steps_done;
  simulation::maintain(c, s.state, s.work);
  simulation::renumber(c, s.state, s.work);
  lap(4);
}

bool same_rock(const Drilling& a, const Drilling& b) {
  const auto &x = a.run.state.rock.surface.stars, &y = b.run.state.rock.surface.stars;
  if (x.size() != y.size()) return false;
  for (std::size_t v = 0; v < x.size(); ++v)
    if (x[v].x != y[v].x || x[v].ring != y[v].ring) return false;
  return true;
}

/// Drills one workload. The first times are on one thread, the second on Options::threads.
std::array<PhaseTimes, 2> measure(const Workload& w, const Options& options) {
  std::array<Drilling, 2> sides;
  for (Drilling& d : sides) d = start_workload(w);
  Drilling plain = start_workload(w);
  std::array<PhaseTimes, 2> times{};
  for (long turn = 0; turn < options.turns; ++turn) {
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const ThreadLimit limit(k == 0 ? 1 : options.threads);
      for (long i = 0; i < steps_of_a_turn; ++i) timed_step(sides[k].plan, sides[k].run, times[k]);
    }
    drill(plain, steps_of_a_turn);
  }
  if (!same_rock(sides[0], sides[1]) || !same_rock(sides[0], plain))
    throw RunError(fmt::format("{}: the rocks of the copies differ", w.name));
  return times;
}

nlohmann::ordered_json report(const Workload& w, const std::array<PhaseTimes, 2>& times,
                              const Options& options) {
  const double us = 1e6 / static_cast<double>(options.turns * steps_of_a_turn);
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  double one = 0.0, more = 0.0;
  fmt::print("\n{:22}{:>12}{:>12}{:>8}\n", w.name, "1 thread us",
             fmt::format("{} threads", options.threads), "ratio");
  const auto add = [&](const std::string& name, double a, double b) {
    fmt::print("{:22}{:12.1f}{:12.1f}{:8.2f}\n", name, a, b, a / b);
    rows.push_back({{"phase", name}, {"one_thread_us", a}, {"threads_us", b}});
  };
  for (std::size_t k = 0; k < phase_names.size(); ++k) {
    add(phase_names[k], us * times[0][k], us * times[1][k]);
    one += us * times[0][k];
    more += us * times[1][k];
  }
  add("step", one, more);
  return {{"workload", w.name}, {"threads", options.threads}, {"phases", rows}};
}

void run(const Options& options) {
  auto all = nlohmann::ordered_json::array();
  for (const std::string& name : options.workloads) {
    const auto found =
        std::ranges::find_if(workloads(), [&](const Workload& w) { return w.name == name; });
    if (found == workloads().end())
      throw InputError(fmt::format("WORKLOAD: found {}, expected a workload of rivals", name));
    all.push_back(report(*found, measure(*found, options), options));
  }
  if (!options.json.empty())
    std::ofstream(options.json) << nlohmann::ordered_json{{"phases", all}}.dump(1) << "\n";
}

}  // namespace
}  // namespace tdbd::bench

int main(int argc, char** argv) {
  tdbd::bench::Options options;
  CLI::App app{"Wall time of the phases of a step on one and on several threads."};
  app.add_option("WORKLOADS", options.workloads, "workloads; five if not given");
  app.add_option("--turns", options.turns, "turns of 100 steps")->check(CLI::PositiveNumber);
  app.add_option("--threads", options.threads, "threads of the second copy")
      ->check(CLI::PositiveNumber);
  app.add_option("--json", options.json, "file for all figures");
  return tdbd::bench::parse_and_run(app, argc, argv, [&] { tdbd::bench::run(options); });
}
