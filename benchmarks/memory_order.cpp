// The effect on the run time of a step, after some revolutions, of neighbours in space that are
// scattered in memory. Compares the rock as it is with copies with a new index and renumbered by
// place. The copies drill alternately, block by block. Prints a row of the study's table:
// revolutions, ratios of the steps with a new index and renumbered to the step as it is, and the
// run time of a renumbering, in ms and in steps.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/drilling.hpp"
#include "rock/start/space_order.hpp"

namespace tdbd::bench {
namespace {

constexpr double edge = 1e-3;

rock::Rock by_place(rock::Rock rock) {
  rock::RenumberWork work;
  rock::renumber(rock, 8.0 * edge, work);
  return rock;
}

/// The median run time of a renumbering of the rock, s, with warm buffers.
double seconds_of_renumbering(const rock::Rock& rock) {
  rock::RenumberWork work;
  std::array<double, 9> seconds{};
  for (double& s : seconds) {
    rock::Rock copy = rock;
    const double start = cpu_seconds();
    rock::renumber(copy, 8.0 * edge, work);
    s = cpu_seconds() - start;
  }
  std::ranges::sort(seconds);
  return seconds[seconds.size() / 2];
}

/// Keeps the numbers, so that only the index is new.
rock::Rock with_rebuilt_index(const rock::Rock& old) {
  mesh::Box room;
  for (const mesh::VertexStar& star : old.surface.stars)
    room.add(star.x + Vec3(0.0, 0.0, 20.0 * edge));
  rock::Rock rock = old;
  rock::Rock fresh = rock::make_rock(old.surface, 2.0 * edge, room);
  rock.grid = std::move(fresh.grid);
  rock.near_lists.clear();
  return rock;
}

Drilling continued(const Drilling& d, rock::Rock rock) {
  Drilling copy{d.plan, {}};
  simulation::State state = d.run.state;
  state.rock = std::move(rock);
  copy.run = simulation::resume(copy.plan, std::move(state), d.run.statistics);
  drill(copy, 20);
  return copy;
}

struct Comparison {
  std::array<double, 2> ratios;  ///< of the second and the third side to the first
  double step;                   ///< s, of the first side
};

/// The medians over blocks of 100 steps.
Comparison compare(std::array<Drilling, 3>& sides) {
  constexpr std::size_t blocks = 16;
  constexpr long steps = 100;
  std::array<std::array<double, blocks>, 2> ratios{};
  std::array<double, blocks> first{};
  for (std::size_t b = 0; b < blocks; ++b) {
    std::array<double, 3> seconds{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double start = cpu_seconds();
      drill(sides[(b + k) % 3], steps);
      seconds[(b + k) % 3] = cpu_seconds() - start;
    }
    for (std::size_t i = 0; i < 2; ++i) ratios[i][b] = seconds[i + 1] / seconds[0];
    first[b] = seconds[0] / steps;
  }
  for (auto& r : ratios) std::ranges::sort(r);
  std::ranges::sort(first);
  return {{ratios[0][blocks / 2], ratios[1][blocks / 2]}, first[blocks / 2]};
}

int run(long revolutions, std::vector<std::string> settings) {
  settings.push_back(fmt::format("time.revolutions={}", revolutions + 10));
  settings.emplace_back("maintenance.renumber_every=0");
  Drilling d = start_drilling("standard-workload", edge, std::move(settings));
  drill(d, revolutions * steps_of_a_revolution(d.plan));
  std::array<Drilling, 3> sides{continued(d, d.run.state.rock),
                                continued(d, with_rebuilt_index(d.run.state.rock)),
                                continued(d, by_place(d.run.state.rock))};
  const double renumbering = seconds_of_renumbering(d.run.state.rock);
  const Comparison c = compare(sides);
  fmt::print("{},{:.3f},{:.3f},{:.1f},{:.1f}\n", revolutions, c.ratios[0], c.ratios[1],
             1e3 * renumbering, renumbering / c.step);
  return 0;
}

}  // namespace
}  // namespace tdbd::bench

int main(int count, char** arguments) {
  if (count < 2) return 2;  // memory_order REVOLUTIONS [KEY=VALUE ...]
  return tdbd::bench::run(std::atol(arguments[1]), {arguments + 2, arguments + count});
}
