#pragma once

#include <optional>
#include <vector>

#include "benchmarks/contenders.hpp"
#include "benchmarks/counters.hpp"

namespace tdbd::bench {

/// Whose seconds: of the processor, for one thread, whatever else it does meanwhile; or of the
/// wall, for several.
enum class Clock { cpu, wall };

double seconds_of(Clock clock);

/// What reading the clock costs, s.
double cost_of(Clock clock);

/// Turns of one contender.
struct Turns {
  std::vector<double> typical;  ///< s a step, of each turn: medians of the kinds of steps, weighed
                                ///< by how often they come
  std::vector<double> means;    ///< s a step, of each turn
  std::vector<double> steps;    ///< s, of all turns
  std::vector<double> instructions, cycles;  ///< a step, of each turn; empty without counters
  double maintaining = 0.0;                  ///< s: maintained steps over the turn's plain median
  long maintained = 0;                       ///< triangles, in all turns
};

/// Drills on for a turn and adds what it took.
void add_turn(const Contender& c, long steps, Clock clock, const Counters& counters, Turns& turns);

/// What a condition says of a contender. Noise only adds: `typical` is the least of the turns.
struct Figures {
  double typical = 0.0;                        ///< s
  double mean = 0.0;                           ///< s: median of the turns' means
  double percentile_99 = 0.0;                  ///< s: of all steps
  std::optional<double> instructions, cycles;  ///< a step: least of the turns
  std::optional<double> maintenance;           ///< s a triangle
};
Figures figures_of(const Turns& turns);

}  // namespace tdbd::bench
