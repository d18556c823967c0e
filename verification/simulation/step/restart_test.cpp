#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"
#include "simulation/start/rock_start.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/simulation/restarted_cases.hpp"

namespace tdbd::simulation::restart_test {

/// The rock under an index of its own, as it would be if only the surface and the marks of its
/// vertices had been saved.
rock::Rock rebuilt(const Case& c, const rock::Rock& from) {
  constexpr double cell_over_edge = 2.0;
  rock::Rock rock = rock::make_rock(from.surface, cell_over_edge * c.rock.edge_length, reach_W(c));
  rock.last_part = from.last_part;
  for (const int v : from.touched_list) rock::touch(rock, v);
  rock.cuts = from.cuts;
  rock.moved_in = from.moved_in;
  rock.pressed = from.pressed;
  rock.carried = from.carried;
  return rock;
}

void expect_same(const FaceStatistics& a, const FaceStatistics& b) {
  EXPECT_EQ(a.refused_deep, b.refused_deep);
  ASSERT_EQ(a.revolution.size(), b.revolution.size());
  for (std::size_t i = 0; i < a.revolution.size(); ++i) {
    EXPECT_EQ(a.revolution[i].area.mean, b.revolution[i].area.mean);
    EXPECT_EQ(a.revolution[i].swept.squares, b.revolution[i].swept.squares);
    EXPECT_EQ(a.revolution[i].removed.squares, b.revolution[i].removed.squares);
  }
}

/// In which order vertices were touched follows the index; what becomes of them does not.
std::vector<int> sorted(std::vector<int> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

void expect_same(const State& a, const State& b) {
  EXPECT_EQ(a.steps_done, b.steps_done);
  EXPECT_EQ(mesh::positions_of(a.rock.surface), mesh::positions_of(b.rock.surface));
  EXPECT_EQ(a.rock.surface.triangles, b.rock.surface.triangles);
  EXPECT_EQ(a.rock.last_part, b.rock.last_part);
  EXPECT_EQ(sorted(a.rock.touched_list), sorted(b.rock.touched_list));
  EXPECT_EQ(a.rock.cuts, b.rock.cuts);
  for (const int v : a.rock.touched_list)
    EXPECT_EQ(a.rock.moved_in[at(v)].first, b.rock.moved_in[at(v)].first);
  ASSERT_EQ(a.rock.pressed.size(), b.rock.pressed.size());
  for (std::size_t i = 0; i < a.rock.pressed.size(); ++i) {
    ASSERT_EQ(a.rock.pressed[i].size(), b.rock.pressed[i].size()) << i;
    for (std::size_t k = 0; k < a.rock.pressed[i].size(); ++k) {
      EXPECT_EQ(a.rock.pressed[i][k].v, b.rock.pressed[i][k].v);
      EXPECT_EQ(a.rock.pressed[i][k].d_W, b.rock.pressed[i][k].d_W);
      EXPECT_EQ(a.rock.pressed[i][k].hold, b.rock.pressed[i][k].hold);
    }
  }
  EXPECT_EQ(a.cut.removed_by_part, b.cut.removed_by_part);
  EXPECT_EQ(a.ledger.removed.value(), b.ledger.removed.value());
  EXPECT_EQ(a.ledger.trimmed.value(), b.ledger.trimmed.value());
  EXPECT_EQ(a.ledger.removed_by_revolution, b.ledger.removed_by_revolution);
  EXPECT_EQ(rock::counts(a.maintenance), rock::counts(b.maintenance));
  EXPECT_EQ(a.maintenance.volume_change, b.maintenance.volume_change);
  EXPECT_EQ(a.trimming.done_W, b.trimming.done_W);
  EXPECT_EQ(a.trimming.triangles, b.trimming.triangles);
  EXPECT_EQ(angles_of(a.cones), angles_of(b.cones));
  EXPECT_EQ(speeds_of(a.cones), speeds_of(b.cones));
  if (!a.drive) return;
  EXPECT_EQ(a.drive->state.c_W, b.drive->state.c_W);
  EXPECT_EQ(a.drive->state.momentum_W, b.drive->state.momentum_W);
  EXPECT_EQ(a.drive->state.rotation.momentum_W, b.drive->state.rotation.momentum_W);
  EXPECT_EQ(a.drive->state.rotation.cone_momenta, b.drive->state.rotation.cone_momenta);
  EXPECT_EQ(a.drive->ledger.cut_bit, b.drive->ledger.cut_bit);
}

void expect_same(const Simulation& a, const Simulation& b) {
  expect_same(a.state, b.state);
  expect_same(a.statistics.faces, b.statistics.faces);
  EXPECT_EQ(a.statistics.energy_by_part, b.statistics.energy_by_part);
  EXPECT_EQ(a.statistics.trace.wob, b.statistics.trace.wob);
  EXPECT_EQ(a.statistics.loads.wob.squares, b.statistics.loads.wob.squares);
  EXPECT_EQ(a.work.loads.force_W, b.work.loads.force_W);
  for (std::size_t k = 0; k < a.statistics.cones.size(); ++k)
    EXPECT_EQ(a.statistics.cones[k].ratio.squares, b.statistics.cones[k].ratio.squares);
}

enum class Index { copied, rebuilt };

/// Whether the last step removed rock.
bool has_cut(const State& s) {
  return std::ranges::any_of(s.cut.removed_by_part, [](double volume) { return volume > 0.0; });
}

/// A run that continues from copies of State and Statistics, with new Work, is bitwise identical to
/// the uninterrupted run. Whether it was stopped while it cut: rolling cones turn by the cut of the
/// step before.
bool check_restart(const Case& c, int before, int after, Index index) {
  SCOPED_TRACE(fmt::format("{} steps, then {}", before, after));
  Simulation whole = start(c);
  for (int i = 0; i < before; ++i) step(c, whole);
  const bool cutting = has_cut(whole.state);
  State state = whole.state;
  if (index == Index::rebuilt) state.rock = rebuilt(c, whole.state.rock);
  Simulation resumed = resume(c, std::move(state), whole.statistics);
  for (int i = 0; i < after; ++i) {
    step(c, whole);
    step(c, resumed);
  }
  expect_same(whole, resumed);
  return cutting;
}

class Restart : public ::testing::TestWithParam<RestartedCase> {
 protected:
  /// At steps of any kind: with and without maintenance before and after them.
  static void check(Index index) {
    const Case c = restarted_case(GetParam());
    Random random{20261122};
    int while_cutting = 0;
    for (int k = 0; k < 4; ++k) {
      const double before = random.uniform(1.0, 60.0), after = random.uniform(1.0, 25.0);
      while_cutting += check_restart(c, static_cast<int>(before), static_cast<int>(after), index);
    }
    EXPECT_GE(while_cutting, 1);  // a bit that stands hardly cuts
  }
};

TEST_P(Restart, needs_state_and_statistics_only) { check(Index::copied); }

TEST_P(Restart, may_rebuild_the_index_of_the_rock) { check(Index::rebuilt); }

INSTANTIATE_TEST_SUITE_P(Cases, Restart, ::testing::ValuesIn(restarted_cases()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace tdbd::simulation::restart_test
