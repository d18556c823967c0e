#pragma once

#include <optional>
#include <vector>

#include "benchmarks/contenders.hpp"
#include "benchmarks/counters.hpp"

namespace tdbd::bench {

/// Which time is measured: CPU time, for one thread, independent of other programs; or wall time,
/// for several threads.
enum class Clock { cpu, wall };

double seconds_of(Clock clock);

/// Time to read the clock, s.
double clock_overhead(Clock clock);

/// Turns of one contender.
struct Turns {
  std::vector<double> typical;  ///< s per step, of each turn: medians of the kinds of steps,
                                ///< weighted by their frequency
  std::vector<double> means;    ///< s per step, of each turn
  std::vector<double> steps;    ///< s, of all turns
  std::vector<double> instructions, cycles;  ///< per step, of each turn; empty without counters
  double maintaining = 0.0;                  ///< s: maintained steps minus the plain median
  long maintained = 0;                       ///< triangles, in all turns
};

/// Drills for one turn and adds its times.
void add_turn(const Contender& c, long steps, Clock clock, const Counters& counters, Turns& turns);

/// Results of a contender under a condition. Noise only increases times, so `typical` is the
/// minimum over the turns.
struct Figures {
  double typical = 0.0;                        ///< s
  double mean = 0.0;                           ///< s: median of the turns' means
  double percentile_99 = 0.0;                  ///< s: over all steps
  std::optional<double> instructions, cycles;  ///< per step: minimum over the turns
  std::optional<double> maintenance;           ///< s per triangle
};
Figures summarize(const Turns& turns);

}  // namespace tdbd::bench
