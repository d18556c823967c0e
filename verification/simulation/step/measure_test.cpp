#include "simulation/step/measure.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulation/step/simulation.hpp"

namespace tdbd::simulation::measure_test {
namespace {

Case steady_case(int section_every) {
  return read_case(
      TDBD_SOURCE_DIR "/cases/bit-b-3000psi.toml",
      {"rock.edge_length='4 mm'", fmt::format("measure.section_every={}", section_every)});
}

/// The same face, and the same number to the bit; NaN is equal to NaN.
bool is_same(const rock::Section& a, const rock::Section& b) {
  const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return same(a.area, b.area) && same(a.engaged_edge, b.engaged_edge) &&
         same(a.volume_rate, b.volume_rate) && same(a.centroid_B.x(), b.centroid_B.x());
}

}  // namespace

/// The motion is prescribed, so that both runs cut the same rock.
TEST(SectionsInTurn, are_those_of_every_step_in_a_faces_turn_and_stay_in_between) {
  constexpr long every = 3;
  const Case each = steady_case(1), in_turn = steady_case(every);
  Simulation a = start(each), b = start(in_turn);
  for (long k = 0; k < 40; ++k) {
    const std::vector<rock::Section> last = b.work.measures.sections;
    step(each, a);
    step(in_turn, b);
    for (std::size_t i = 0; i < last.size(); ++i) {
      const bool is_due = (k + static_cast<long>(i)) % every == 0;
      const rock::Section& now = b.work.measures.sections[i];
      EXPECT_TRUE(is_same(now, is_due ? a.work.measures.sections[i] : last[i])) << k << ' ' << i;
      EXPECT_EQ(b.work.measures.is_new[i] != 0, is_due);
    }
    if (k == 0) {
      EXPECT_TRUE(std::ranges::equal(a.work.measures.sections, b.work.measures.sections, is_same));
    }
  }
}

/// What is removed counts in every step.
TEST(SectionsInTurn, count_once_each) {
  const Case c = steady_case(4);
  Simulation s = start(c);
  for (int k = 0; k < 41; ++k) step(c, s);
  const FaceStatistics& faces = s.statistics.faces;
  ASSERT_EQ(faces.refused_deep + faces.refused_over_the_top, 0);
  for (std::size_t i = 0; i < faces.revolution.size(); ++i) {
    const FaceSpreads& spreads = faces.revolution[i];
    EXPECT_EQ(spreads.area.count, 11) << i;  // in the first step, and ten times in its turn
    EXPECT_EQ(spreads.swept.count, spreads.area.count);
    EXPECT_EQ(spreads.removed.count, 41);
  }
}

/// A section that cannot be told is refused once, and counts for nothing until the next.
TEST(SectionsInTurn, are_refused_once_each) {
  FaceStatistics statistics;
  statistics.revolution.resize(1);
  Measures m;
  m.sections.resize(1);
  m.removed = {1e-9};
  m.is_new = {1};
  m.sections[0].area = NAN;
  m.sections[0].sight = rock::Sight::none;
  Move move;
  add(move, m, statistics);
  m.is_new = {0};
  add(move, m, statistics);
  add(move, m, statistics);
  EXPECT_EQ(statistics.refused_deep, 1);
  EXPECT_EQ(statistics.revolution[0].removed.count, 0);
}

}  // namespace tdbd::simulation::measure_test
