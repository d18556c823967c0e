// Run times of steps of TDBD workloads, height fields and spokes, measured alternately in one run
// and divided by that of a step of the height field of 0.5 mm. benchmarks/README.md explains the
// table.

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "benchmarks/command.hpp"
#include "benchmarks/rivals_table.hpp"
#include "core/parallel.hpp"

namespace tdbd::bench {
namespace {

struct ProgramOptions {
  std::vector<std::string> only, settings;
  int threads = 1;
  long warm_turns = 5, cold_turns = 15;
  std::string json, histogram;
};

std::vector<Turns> measure(const std::vector<Contender>& sides, const Condition& condition,
                           Clock clock, const Counters& counters) {
  std::vector<Turns> turns(sides.size());
  for (long turn = 0; turn < condition.turns; ++turn)
    for (std::size_t i = 0; i < sides.size(); ++i)
      add_turn(sides[i], condition.steps, clock, counters, turns[i]);
  return turns;
}

std::vector<Figures> summarize(const std::vector<Turns>& turns) {
  std::vector<Figures> figures;
  for (const Turns& t : turns) figures.push_back(summarize(t));
  return figures;
}

/// Writes a histogram of the step times of each side, divided by the mean step time of the
/// yardstick. Rows are bins of a tenth; the last row contains all slower steps.
void write_histogram(const std::string& file, const std::vector<Contender>& sides,
                     const std::vector<Turns>& turns) {
  constexpr std::size_t bins = 80;
  constexpr double per_mean = 10.0;
  double mean = 0.0;
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (sides[i].name == yardstick) mean = summarize(turns[i]).mean;
  std::vector<std::vector<long>> counts(sides.size(), std::vector<long>(bins, 0));
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (const double seconds : turns[i].steps)
      ++counts[i][std::min(bins - 1, static_cast<std::size_t>(per_mean * seconds / mean))];
  std::ofstream out(file);
  out << "times the mean of " << yardstick;
  for (const Contender& side : sides) out << "," << side.name;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    out << fmt::format("\n{:.1f}", static_cast<double>(bin) / per_mean);
    for (const std::vector<long>& c : counts) out << "," << c[bin];
  }
  out << "\n";
}

void run(const ProgramOptions& wish) {
  const Counters counters;  // before any thread starts
  const ThreadLimit threads(wish.threads);
  const Clock clock = wish.threads > 1 ? Clock::wall : Clock::cpu;
  const char* const time = clock == Clock::cpu ? "CPU" : "wall";
  const double clock_us = 1e6 * clock_overhead(clock);
  const std::vector<Contender> sides = contenders(wish.only, wish.settings);
  fmt::print("{} time, {} thread(s); reading the clock takes {:.2f} us; ratios are over {}\n", time,
             wish.threads, clock_us, yardstick);
  auto conditions = nlohmann::ordered_json::array();
  for (const Condition& c :
       {Condition{"warm", 500, wish.warm_turns}, Condition{"cold", 100, wish.cold_turns}}) {
    if (c.turns <= 0) continue;
    const std::vector<Turns> turns = measure(sides, c, clock, counters);
    conditions.push_back(condition_json(c, sides, summarize(turns)));
    if (c.name == "warm" && !wish.histogram.empty()) write_histogram(wish.histogram, sides, turns);
    fmt::print("{}", condition_text(conditions.back()));
  }
  if (wish.json.empty()) return;
  const nlohmann::ordered_json all{{"threads", wish.threads},
                                   {"time", time},
                                   {"clock_us", clock_us},
                                   {"settings", wish.settings},
                                   {"conditions", conditions}};
  std::ofstream(wish.json) << all.dump(1) << "\n";
}

}  // namespace
}  // namespace tdbd::bench

int main(int argc, char** argv) {
  tdbd::bench::ProgramOptions wish;
  CLI::App app{"A step of ours over a step of a height field, in one run."};
  app.add_option("--only", wish.only, "workloads; all if not given");
  app.add_option("--set", wish.settings, "KEY=VALUE of every case of ours");
  app.add_option("--threads", wish.threads, "threads of ours; several are timed by the wall")
      ->check(CLI::PositiveNumber);
  app.add_option("--warm-turns", wish.warm_turns, "turns of 500 steps");
  app.add_option("--cold-turns", wish.cold_turns, "turns of 100 steps");
  app.add_option("--json", wish.json, "file that gets all figures");
  app.add_option("--histogram", wish.histogram, "CSV file for a histogram of the warm step times");
  return tdbd::bench::parse_and_run(app, argc, argv, [&] { tdbd::bench::run(wish); });
}
