// Time saved by renumbering in a long run. The same case with several intervals between
// renumberings drills alternately, block by block. Prints for each interval the ratio of the run
// time of its steps to that of the first interval, as the median over the blocks, and the ratio for
// the whole run, including renumberings.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "benchmarks/drilling.hpp"

namespace tdbd::bench {
namespace {

struct Side {
  std::string every;  ///< steps between renumberings
  Drilling drilling;
  double seconds = 0.0;
  std::vector<double> ratios;  ///< of each block to that of the first side
};

std::vector<Side> start_sides(long revolutions, const std::vector<std::string>& intervals) {
  std::vector<Side> sides;
  for (const std::string& every : intervals)
    sides.push_back({every,
                     start_drilling("standard-workload", 1e-3,
                                    {"maintenance.renumber_every=" + every,
                                     fmt::format("time.revolutions={}", revolutions)}),
                     0.0,
                     {}});
  return sides;
}

/// Every side drills a block. The first side changes from block to block.
void drill_block(long block, std::vector<Side>& sides) {
  constexpr long steps = 100;
  std::vector<double> seconds(sides.size());
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const std::size_t i = (static_cast<std::size_t>(block) + k) % sides.size();
    const double start = cpu_seconds();
    drill(sides[i].drilling, steps);
    seconds[i] = cpu_seconds() - start;
  }
  for (std::size_t i = 0; i < sides.size(); ++i) {
    sides[i].seconds += seconds[i];
    sides[i].ratios.push_back(seconds[i] / seconds[0]);
  }
}

int run(long revolutions, const std::vector<std::string>& intervals) {
  std::vector<Side> sides = start_sides(revolutions, intervals);
  const long blocks = revolutions * steps_of_a_revolution(sides[0].drilling.plan) / 100;
  for (long b = 0; b < blocks; ++b) drill_block(b, sides);
  for (Side& s : sides) {
    std::ranges::sort(s.ratios);
    fmt::print("{},{},{:.3f},{:.3f}\n", revolutions, s.every, s.ratios[s.ratios.size() / 2],
               s.seconds / sides[0].seconds);
  }
  return 0;
}

}  // namespace
}  // namespace tdbd::bench

int main(int count, char** arguments) {
  if (count < 3) return 2;  // renumbering REVOLUTIONS STEPS [STEPS ...]
  return tdbd::bench::run(std::atol(arguments[1]), {arguments + 2, arguments + count});
}
