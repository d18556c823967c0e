#include "benchmarks/turns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "benchmarks/drilling.hpp"

namespace tdbd::bench {
namespace {

/// Seconds of a turn's steps, by StepKind.
using StepTimes = std::array<std::vector<double>, 2>;

/// The quantile of the values at this share, 0 to 1.
double quantile(std::vector<double> values, double share) {
  const auto at = values.begin() + std::lround(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

std::optional<double> least_of(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return *std::min_element(values.begin(), values.end());
}

StepTimes drill_turn(const Contender& c, long steps, Clock clock) {
  StepTimes times;
  double before = seconds_of(clock);
  for (long i = 0; i < steps; ++i) {
    const auto kind = static_cast<std::size_t>(c.step());
    const double now = seconds_of(clock);
    times[kind].push_back(now - before);
    before = now;
  }
  return times;
}

void add_times(const StepTimes& times, long steps, Turns& turns) {
  double typical = 0.0, all = 0.0;
  for (const std::vector<double>& seconds : times) {
    if (seconds.empty()) continue;
    typical += static_cast<double>(seconds.size()) * quantile(seconds, 0.5);
    all += sum_of(seconds);
    turns.steps.insert(turns.steps.end(), seconds.begin(), seconds.end());
  }
  turns.typical.push_back(typical / static_cast<double>(steps));
  turns.means.push_back(all / static_cast<double>(steps));
  const auto& [plain, maintained] = times;
  if (!plain.empty())
    for (const double seconds : maintained) turns.maintaining += seconds - quantile(plain, 0.5);
}

void add_count(const std::optional<double>& before, const std::optional<double>& after, long steps,
               std::vector<double>& counts) {
  if (before && after) counts.push_back((*after - *before) / static_cast<double>(steps));
}

}  // namespace

double seconds_of(Clock clock) { return clock == Clock::cpu ? cpu_seconds() : wall_seconds(); }

double clock_overhead(Clock clock) {
  constexpr int reads = 10000;
  const double start = seconds_of(clock);
  for (int i = 1; i < reads; ++i) seconds_of(clock);
  return (seconds_of(clock) - start) / reads;
}

void add_turn(const Contender& c, long steps, Clock clock, const Counters& counters, Turns& turns) {
  const long maintained = c.mesh ? c.mesh().maintained : 0;
  const auto instructions = counters.instructions.value(), cycles = counters.cycles.value();
  const StepTimes times = drill_turn(c, steps, clock);
  add_count(instructions, counters.instructions.value(), steps, turns.instructions);
  add_count(cycles, counters.cycles.value(), steps, turns.cycles);
  add_times(times, steps, turns);
  turns.maintained += c.mesh ? c.mesh().maintained - maintained : 0;
}

Figures summarize(const Turns& turns) {
  Figures f{*least_of(turns.typical),     quantile(turns.means, 0.5), quantile(turns.steps, 0.99),
            least_of(turns.instructions), least_of(turns.cycles),     {}};
  if (turns.maintained > 0) f.maintenance = turns.maintaining / double(turns.maintained);
  return f;
}

}  // namespace tdbd::bench
