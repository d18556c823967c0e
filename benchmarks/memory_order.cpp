// What a step costs more after so many revolutions because neighbours in space are scattered in
// memory: the same rock as it is, with a new index, and with vertices and triangles renumbered by
// place. The copies drill on in turn, block by block. Prints a row of the study's table.

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

/// The rock with its vertices in this order, its index made anew.
rock::Rock renumbered(const rock::Rock& old, const std::vector<int>& slots) {
  std::vector<int> number(old.surface.stars.size(), -1);
  mesh::TriangleMesh m;
  for (const int v : slots) {
    number[at(v)] = static_cast<int>(m.positions.size());
    m.positions.push_back(old.surface.position(v));
  }
  for (const auto& [a, b, c] : old.surface.triangles)
    if (a >= 0) m.triangles.push_back({number[at(a)], number[at(b)], number[at(c)]});
  std::ranges::sort(m.triangles, {}, [](const mesh::Triangle& t) { return std::ranges::min(t); });
  mesh::Box room;
  for (const Vec3& x : m.positions) room.add(x + Vec3(0.0, 0.0, 20.0 * edge));
  rock::Rock rock = rock::make_rock(mesh::make_surface(m), 2.0 * edge, room);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    rock.last_part[i] = old.last_part[at(slots[i])];
    rock.touched[i] = old.touched[at(slots[i])];
    rock.moved_in[i] = old.moved_in[at(slots[i])];
  }
  rock.cuts = old.cuts;
  for (const int v : old.touched_list)
    if (number[at(v)] >= 0) rock.touched_list.push_back(number[at(v)]);
  return rock;
}

rock::Rock by_place(const rock::Rock& old) {
  std::vector<int> slots;
  const mesh::TriangleMesh m = mesh::compact(old.surface, &slots);
  std::vector<int> order = rock::order_of_space(m.positions, 8.0 * edge);
  for (int& i : order) i = slots[at(i)];
  return renumbered(old, order);
}

/// The same numbers, so that only the index is new.
rock::Rock indexed_anew(const rock::Rock& old) {
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

/// The medians, over blocks of 100 steps, of the cost of the second and the third over the first.
std::array<double, 2> compare(std::array<Drilling, 3>& sides) {
  constexpr std::size_t blocks = 16;
  std::array<std::array<double, blocks>, 2> ratios{};
  for (std::size_t b = 0; b < blocks; ++b) {
    std::array<double, 3> seconds{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double start = cpu_seconds();
      drill(sides[(b + k) % 3], 100);
      seconds[(b + k) % 3] = cpu_seconds() - start;
    }
    for (std::size_t i = 0; i < 2; ++i) ratios[i][b] = seconds[i + 1] / seconds[0];
  }
  for (auto& r : ratios) std::ranges::sort(r);
  return {ratios[0][blocks / 2], ratios[1][blocks / 2]};
}

int run(long revolutions, std::vector<std::string> settings) {
  settings.push_back(fmt::format("time.revolutions={}", revolutions + 10));
  Drilling d = start_drilling("standard-workload", edge, std::move(settings));
  drill(d, revolutions * steps_of_a_revolution(d.plan));
  std::array<Drilling, 3> sides{continued(d, d.run.state.rock),
                                continued(d, indexed_anew(d.run.state.rock)),
                                continued(d, by_place(d.run.state.rock))};
  const auto [index, place] = compare(sides);
  fmt::print("{},{:.3f},{:.3f}\n", revolutions, index, place);
  return 0;
}

}  // namespace
}  // namespace tdbd::bench

int main(int count, char** arguments) {
  if (count < 2) return 2;  // memory_order REVOLUTIONS [KEY=VALUE ...]
  return tdbd::bench::run(std::atol(arguments[1]), {arguments + 2, arguments + count});
}
