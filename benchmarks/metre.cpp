// A metre of hole by bit B with 2.0 mm edges: wall time and memory at each tenth.
//   build/bench/benchmarks/metre
// The wall is trimmed 140 mm above the bit, so that neither time nor memory grows with the hole.

#include <fmt/format.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "benchmarks/command.hpp"
#include "benchmarks/workloads.hpp"
#include "core/parallel.hpp"

namespace tdbd::bench {
namespace {

struct ProgramOptions {
  double length = 1.0;  ///< m
  int threads = 2;
  std::vector<std::string> settings;
  std::string json;
};

/// Peak memory of the program so far, MB.
double peak_megabytes() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / 1024.0;
}

/// State at the end of a tenth.
struct Tenth {
  double depth, wall, peak;  ///< m, s, MB
  long triangles;
};

std::vector<Tenth> drill_tenths(Drilling& d, const ProgramOptions& wish, long steps) {
  std::vector<Tenth> tenths;
  fmt::print("{:>8}{:>10}{:>12}{:>12}{:>12}\n", "m", "wall s", "us a step", "peak MB", "triangles");
  const double start = wall_seconds();
  for (long n = 1; n <= 10; ++n) {
    const double before = wall_seconds();
    const long now = steps * n / 10 - steps * (n - 1) / 10;
    drill(d, now);
    const Tenth& t = tenths.emplace_back(Tenth{0.1 * wish.length * static_cast<double>(n),
                                               wall_seconds() - start, peak_megabytes(),
                                               d.run.state.rock.surface.triangle_count()});
    fmt::print("{:8.2f}{:10.2f}{:12.1f}{:12.1f}{:12}\n", t.depth, t.wall,
               1e6 * (wall_seconds() - before) / static_cast<double>(now), t.peak, t.triangles);
    std::fflush(stdout);
  }
  return tenths;
}

void write_json(const ProgramOptions& wish, long steps, const std::vector<Tenth>& tenths) {
  auto rows = nlohmann::ordered_json::array();
  for (const Tenth& t : tenths)
    rows.push_back(
        {{"m", t.depth}, {"wall_s", t.wall}, {"peak_MB", t.peak}, {"triangles", t.triangles}});
  const nlohmann::ordered_json metre{
      {"m", wish.length},
      {"steps", steps},
      {"threads", wish.threads},
      {"wall_s", tenths.back().wall},
      {"peak_MB", tenths.back().peak},
      {"peak_last_over_second_tenth", tenths.back().peak / tenths[1].peak},
      {"tenths", rows}};
  std::ofstream(wish.json) << nlohmann::ordered_json{{"metre", metre}}.dump(1) << "\n";
}

void run(const ProgramOptions& wish) {
  const ThreadLimit threads(wish.threads);
  Drilling d = start_workload(metre_workload(), wish.settings, 0);
  const double per_step = d.plan.motion.rate_of_penetration * d.plan.time.step;
  const long steps = std::lround(wish.length / per_step);
  fmt::print("{} steps of {:.2f} um on {} thread(s)\n", steps, 1e6 * per_step, wish.threads);
  const std::vector<Tenth> tenths = drill_tenths(d, wish, steps);
  fmt::print("volumes balance to {:.1e}\n", simulation::ledger_defect(d.run));
  if (!wish.json.empty()) write_json(wish, steps, tenths);
}

}  // namespace
}  // namespace tdbd::bench

int main(int argc, char** argv) {
  tdbd::bench::ProgramOptions wish;
  CLI::App app{"A metre of hole by bit B at 2.0 mm edges."};
  app.add_option("--length", wish.length, "m")->check(CLI::PositiveNumber);
  app.add_option("--threads", wish.threads, "threads")->check(CLI::PositiveNumber);
  app.add_option("--set", wish.settings, "KEY=VALUE of the case");
  app.add_option("--json", wish.json, "file that gets all figures");
  return tdbd::bench::parse_and_run(app, argc, argv, [&] { tdbd::bench::run(wish); });
}
