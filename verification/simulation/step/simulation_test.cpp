#include "simulation/step/simulation.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace tdbd::simulation::simulation_test {

Case with(std::vector<std::string> settings) {
  settings.insert(settings.end(), {"rock.edge_length='5 mm'", "time.revolutions=0.02"});
  return read_case(TDBD_SOURCE_DIR "/cases/bit-b-3000psi.toml", settings);
}

/// Lengths over the edge length of 5 mm.
TEST(StartOfARun, stores_every_number_of_the_case) {
  const Case c = with({"maintenance.rest=3", "maintenance.longest_wait=11",
                       "maintenance.shortest_edge=0.3", "maintenance.longest_edge=1.9",
                       "maintenance.worst_quality=0.11", "maintenance.flip_quality=0.22",
                       "maintenance.smooth_quality=0.33", "maintenance.smoothing=off",
                       "update.most_passes=17", "measure.contact=on", "measure.contact_gap=0.3"});
  const Work w = start(c).work;
  EXPECT_EQ(w.limits.rest, 3);
  EXPECT_EQ(w.limits.longest_wait, 11);
  EXPECT_DOUBLE_EQ(w.limits.shortest_edge, 0.0015);
  EXPECT_DOUBLE_EQ(w.limits.longest_edge, 0.0095);
  EXPECT_EQ(w.limits.worst_quality, 0.11);
  EXPECT_EQ(w.limits.flip_quality, 0.22);
  EXPECT_EQ(w.limits.smooth_quality, 0.33);
  EXPECT_EQ(w.limits.smoothing, rock::Smoothing::off);
  EXPECT_EQ(w.cut_work.most_passes, 17);
  EXPECT_DOUBLE_EQ(w.cut_work.contact_gap, 0.0015);
  EXPECT_EQ(w.faces.faces.size(), c.bit.cutters.size());
  const Case bare = read_case(TDBD_SOURCE_DIR "/cases/bit-b-steady.toml",
                              {"rock.edge_length='5 mm'", "measure.contact=off"});
  EXPECT_LT(start(bare).work.cut_work.contact_gap, 0.0) << "disabled";
}

TEST(StartOfARun, stops_where_passes_do_not_end) {
  const Case c = with({"update.most_passes=1"});
  Simulation s = start(c);
  EXPECT_THROW(
      {
        while (s.state.steps_done < c.time.steps) step(c, s);
      },
      RunError);
}

/// Where the motion is by then, and no farther than it has turned since.
TEST(StartOfARun, that_continues_begins_at_the_last_position) {
  const Case c = with({"time.first_step=4"});
  const Simulation s = start(c);
  EXPECT_EQ(s.state.steps_done, 4);
  EXPECT_EQ(s.state.place.X_WB.p, pose_at(c.motion, 4 * c.time.step).p);
  EXPECT_DOUBLE_EQ(s.state.start_turned, 4 * c.time.step * c.motion.rotary_speed);
  EXPECT_EQ(s.state.place.turned, s.state.start_turned);
  EXPECT_EQ(s.state.start_triangles, s.state.rock.surface.triangle_count());
  EXPECT_EQ(s.statistics.faces.revolution.size(), c.bit.cutters.size());
}

/// A volume that is in no account, over the largest of the accounts.
TEST(LedgerDefect, is_what_no_account_has_over_the_largest) {
  const Case c = with({});
  Simulation s = start(c);
  EXPECT_LT(ledger_defect(s), 1e-14);
  const double hole = s.state.ledger.hole_start;
  s.state.ledger.removed.add(0.1 * hole);
  EXPECT_NEAR(ledger_defect(s), 0.1, 1e-12);
  s.state.ledger.trimmed.add(0.1 * hole);
  EXPECT_NEAR(ledger_defect(s), 0.0, 1e-12);
  s.state.maintenance.volume_change = -0.3 * hole;
  EXPECT_NEAR(ledger_defect(s), 0.3, 1e-12);
  s.state.ledger.removed.add(3.9 * hole);
  EXPECT_NEAR(ledger_defect(s), 3.6 / 4.0, 1e-12);
}

}  // namespace tdbd::simulation::simulation_test
