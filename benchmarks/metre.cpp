// A metre of hole by bit B at 2.0 mm edges: wall time and memory at each tenth.
//   build/bench/benchmarks/metre
// The wall is trimmed 140 mm above the bit, so that neither time nor memory grows with the hole.

#include <fmt/format.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "benchmarks/command.hpp"
#include "benchmarks/drilling.hpp"
#include "core/parallel.hpp"

namespace tdbd::bench {
namespace {

constexpr double edge_length = 2.0e-3;  // m

struct Wish {
  double length = 1.0;  ///< m
  int threads = 2;
  std::vector<std::string> settings;
};

/// The most that the program has held so far, MB.
double peak_megabytes() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / 1024.0;
}

void run(const Wish& wish) {
  const ThreadLimit threads(wish.threads);
  std::vector<std::string> settings = {"rock.trim=0.14"};
  settings.insert(settings.end(), wish.settings.begin(), wish.settings.end());
  Drilling d = start_drilling("bit-b-steady", edge_length, settings);
  const double per_step = d.plan.motion.rate_of_penetration * d.plan.time.step;
  const long steps = std::lround(wish.length / per_step);
  fmt::print("{} steps of {:.2f} um on {} thread(s)\n{:>8}{:>10}{:>12}{:>12}{:>12}\n", steps,
             1e6 * per_step, wish.threads, "m", "wall s", "us a step", "peak MB", "triangles");
  const double start = wall_seconds();
  for (long tenth = 1; tenth <= 10; ++tenth) {
    const double before = wall_seconds();
    const long now = steps * tenth / 10 - steps * (tenth - 1) / 10;
    drill(d, now);
    fmt::print("{:8.2f}{:10.2f}{:12.1f}{:12.1f}{:12}\n", 0.1 * wish.length * double(tenth),
               wall_seconds() - start, 1e6 * (wall_seconds() - before) / double(now),
               peak_megabytes(), d.run.state.rock.surface.triangle_count());
    std::fflush(stdout);
  }
  fmt::print("ledger defect {:.1e}\n", simulation::ledger_defect(d.run));
}

}  // namespace
}  // namespace tdbd::bench

int main(int argc, char** argv) {
  tdbd::bench::Wish wish;
  CLI::App app{"A metre of hole by bit B at 2.0 mm edges."};
  app.add_option("--length", wish.length, "m")->check(CLI::PositiveNumber);
  app.add_option("--threads", wish.threads, "threads")->check(CLI::PositiveNumber);
  app.add_option("--set", wish.settings, "KEY=VALUE of the case");
  return tdbd::bench::parse_and_run(app, argc, argv, [&] { tdbd::bench::run(wish); });
}
