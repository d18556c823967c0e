#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/tolerance.hpp"
#include "simulation/step/simulation.hpp"
#include "simulation/step/step.hpp"

namespace tdbd::simulation::late_start_test {

/// Bit B in coarse rock, fast; `areas` below bit.set.areas. The bottom at the start conforms to the
/// parts that cut from the beginning, so that rock is inside those that wait, or is flat.
Case with_areas(const std::vector<std::string>& areas, const std::string& shape = "conforming") {
  std::vector<std::string> settings{"rock.edge_length='4 mm'", "rock.shape=" + shape,
                                    "motion.rate_of_penetration='200 m/h'"};
  for (const std::string& s : areas) settings.push_back("bit.set.areas." + s);
  return read_case(TDBD_SOURCE_DIR "/cases/bit-b-3000psi.toml", settings);
}

/// Parts of cutters on the blade that waits in most of these tests.
bool waits_at_first(const Case& c, std::size_t part) {
  const int cutter = c.bit.parts[part].cutter;
  return cutter >= 0 && c.bit.cutters[static_cast<std::size_t>(cutter)].blade == 2;
}

double removed_by_waiting(const Case& c, const Simulation& s) {
  double sum = 0.0;
  for (std::size_t i = 0; i < c.bit.parts.size(); ++i)
    if (waits_at_first(c, i)) sum += s.state.ledger.removed_by_part[i].value();
  return sum;
}

void expect_same_state(const Simulation& a, const Simulation& b) {
  EXPECT_EQ(a.state.ledger.removed.value(), b.state.ledger.removed.value());
  ASSERT_EQ(a.state.rock.surface.vertex_count(), b.state.rock.surface.vertex_count());
  for (int v = 0; v < a.state.rock.surface.vertex_count(); ++v)
    ASSERT_EQ(a.state.rock.surface.position(v), b.state.rock.surface.position(v)) << v;
  EXPECT_EQ(a.work.loads.force_W, b.work.loads.force_W);
  EXPECT_EQ(a.work.loads.torque_W, b.work.loads.torque_W);
}

/// Before the event the run is bitwise that of a bit whose parts never cut, except for the mass.
TEST(LateStart, is_until_its_event_that_of_parts_that_never_cut) {
  const Case waits = with_areas({"a.blade=2", "a.removal.from_time='1 s'"}),
             never = with_areas({"a.blade=2", "a.removal.cutting=no"});
  Simulation a = start(waits), b = start(never);
  for (int i = 0; i < 20; ++i) {
    step(waits, a);
    step(never, b);
  }
  expect_same_state(a, b);
  EXPECT_EQ(removed_by_waiting(waits, a), 0.0);
  EXPECT_GT(a.state.ledger.removed.value(), 0.0);
}

/// An event before the first step changes nothing: the run is bitwise that without areas. The flat
/// bottom is at the depth of the nose, with the shoulder and without.
TEST(LateStart, before_the_first_step_changes_nothing) {
  const Case waits = with_areas({"a.zone=shoulder", "a.removal.from_time='1 ns'"}, "flat"),
             plain = with_areas({}, "flat");
  Simulation a = start(waits), b = start(plain);
  for (int i = 0; i < 40; ++i) {
    step(waits, a);
    step(plain, b);
  }
  EXPECT_GT(a.state.ledger.removed.value(), 0.0);
  EXPECT_EQ(a.work.waits, Waits::none);
  expect_same_state(a, b);
}

/// The parts start in the step whose middle is the first after the time, and the ledger of volume
/// closes over the step in which the rock inside them leaves.
TEST(LateStart, by_time_starts_in_its_step_with_a_closed_ledger) {
  const Case c = with_areas({"a.blade=2", "a.removal.from_time='10 ms'"});
  const long first = std::lround(10e-3 / c.time.step);
  ASSERT_GT(first, 2);
  Simulation s = start(c);
  for (long i = 0; i < first; ++i) step(c, s);
  EXPECT_EQ(s.work.waits, Waits::some);
  EXPECT_EQ(removed_by_waiting(c, s), 0.0);
  step(c, s);
  EXPECT_EQ(s.work.waits, Waits::none);
  EXPECT_GT(removed_by_waiting(c, s), 0.0);
  for (int i = 0; i < 40; ++i) step(c, s);
  EXPECT_LE(ledger_defect(s), tolerance::ledger);
}

/// By depth: the bit goes down by rate times time.
TEST(LateStart, by_depth_starts_when_the_bit_has_gone_down) {
  const Case plain = with_areas({});
  const double advance = plain.motion.rate_of_penetration * plain.time.step;
  const Case c = with_areas({"a.blade=2", fmt::format("a.removal.from_depth={}", 6.5 * advance)});
  Simulation s = start(c);
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(s.work.waits, Waits::some) << i;
    step(c, s);
  }
  step(c, s);
  EXPECT_EQ(s.work.waits, Waits::none);
}

/// Runs resumed from copies, from two steps before the start to two after it, continue bitwise.
TEST(LateStart, is_resumed_from_a_copy_of_the_state) {
  const Case c = with_areas({"a.blade=2", fmt::format("a.removal.from_time={}", 8e-3)});
  const long first = std::lround(8e-3 / c.time.step);
  Simulation s = start(c);
  for (const long steps : {first - 2, 1L, 1L, 1L, 1L}) {
    for (long i = 0; i < steps; ++i) step(c, s);
    Simulation again = resume(c, s.state, s.statistics);
    EXPECT_EQ(again.work.waits, s.work.waits);
    Simulation copy = s;
    for (int i = 0; i < 5; ++i) {
      step(c, again);
      step(c, copy);
    }
    expect_same_state(again, copy);
  }
  EXPECT_EQ(s.work.waits, Waits::none);
}

/// A cutter that is wholly in rock when it starts has no way for the rock to leave.
TEST(LateStart, deep_in_rock_is_rejected_with_the_part) {
  const Case c = with_areas(
      {"a.zone=nose", "a.removal.from_depth='20 mm'", "b.zone=cone", "b.removal.cutting=no"});
  Simulation s = start(c);
  s.state.place.X_WB.p.z() += 50e-3;
  try {
    step(c, s);
    FAIL() << "a part deep in rock started";
  } catch (const RunError& e) {
    EXPECT_NE(std::string(e.what()).find("below the rock's surface"), std::string::npos)
        << e.what();
  }
}

}  // namespace tdbd::simulation::late_start_test
