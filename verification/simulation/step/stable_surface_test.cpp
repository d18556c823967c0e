#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/tolerance.hpp"
#include "mesh/measures.hpp"
#include "reference/mesh/self_intersections.hpp"
#include "rock/maintain/invariants.hpp"
#include "simulation/step/step.hpp"

/// Short versions of the long runs in src/rock/README.md: whatever drills, the surface stays sound.
namespace tdbd::simulation::stable_surface_test {

struct Run {
  const char* name;
  const char* file;
  std::vector<std::string> overrides;
  double one_percent = 0.5;   ///< quality that 99 % of the triangles exceed
  double disturbed = 1.3e-4;  ///< volume that maintenance moves, over what is removed
};

void PrintTo(const Run& run, std::ostream* out) { *out << run.name; }

class StableSurface : public testing::TestWithParam<Run> {
 protected:
  StableSurface()
      : case_(read_case(std::string(TDBD_SOURCE_DIR "/cases/") + GetParam().file,
                        GetParam().overrides)),
        simulation_(start(case_)) {}

  void drill(long steps) {
    while (simulation_.state.steps_done < steps) step(case_, simulation_);
  }

  Case case_;
  Simulation simulation_;
};

/// M1 to M7 of one maintenance of what the last step touched.
std::string broken_promises(Simulation& s) {
  const rock::Rock before = s.state.rock;
  rock::MaintenanceReport report;
  rock::maintain(s.state.rock, s.work.limits, s.work.maintenance_work, report);
  const auto found = rock::check_maintenance(before, s.state.rock, s.work.limits, report,
                                             s.work.maintenance_work.drift);
  rock::add(report, s.state.maintenance);
  return rock::describe(found);
}

/// The most steps since the first cut of a vertex that still waits to be maintained.
int longest_wait(const rock::Rock& rock) {
  int longest = 0;
  for (const int v : rock.touched_list)
    longest = std::max(longest, rock.cuts - rock.moved_in[at(v)].first);
  return longest;
}

/// The share of triangles worse than an operation may make. Cuts leave some, and where every repair
/// is refused they stay (M2).
double share_worse_than_made(const mesh::Surface& s, double worst_made) {
  const mesh::TriangleMesh m = mesh::compact(s);
  const auto worse = std::ranges::count_if(m.triangles, [&](const mesh::Triangle& t) {
    return mesh::triangle_quality(mesh::position(m, t[0]), mesh::position(m, t[1]),
                                  mesh::position(m, t[2])) < worst_made;
  });
  return static_cast<double>(worse) / static_cast<double>(m.triangles.size());
}

TEST_P(StableSurface, keeps_its_promises) {
  drill(case_.time.steps - case_.maintenance.every / 2);
  EXPECT_EQ(broken_promises(simulation_), "");
  EXPECT_LT(longest_wait(simulation_.state.rock), case_.maintenance.longest_wait);
  const mesh::Surface& s = simulation_.state.rock.surface;
  EXPECT_EQ(reference::self_intersecting_pairs(mesh::compact(s)), 0U);
  EXPECT_LE(ledger_defect(simulation_), tolerance::ledger);
  const auto [worst, one_percent] = mesh::quality_statistics(s);
  const double disturbed =
      simulation_.state.maintenance.volume_disturbed / simulation_.state.ledger.removed.value();
  const double worse = share_worse_than_made(s, case_.maintenance.worst_quality);
  fmt::print(
      "worst quality {:.3f}, {:.1e} below 0.1, 99 % above {:.3f}; maintenance disturbed {:.1e}\n",
      worst, worse, one_percent, disturbed);
  EXPECT_LE(worse, 1e-4);
  EXPECT_GT(one_percent, GetParam().one_percent);
  EXPECT_LT(disturbed, GetParam().disturbed);
}

const std::string coarse = "rock.edge_length='3 mm'";

INSTANTIATE_TEST_SUITE_P(
    of, StableSurface,
    testing::Values(Run{"a_core", "core.toml", {coarse, "time.revolutions=30"}},
                    Run{"backward_whirl", "bit-b-whirl.toml", {coarse, "time.revolutions=6"}},
                    Run{"forward_whirl",
                        "bit-b-whirl.toml",
                        {coarse, "time.revolutions=6", "motion.whirl.sense='forward'"}},
                    Run{"rolling_cones",
                        "bit-r-rolling.toml",
                        {"rock.edge_length='4 mm'", "time.step='4 ms'", "time.revolutions=12"}},
                    Run{"milled_teeth",
                        "bit-m-steady.toml",
                        {"rock.edge_length='2.5 mm'", "time.step='2 ms'", "time.revolutions=3"},
                        0.35,     // their craters have steep flanks, and crests of less than
                        2.5e-3},  // an edge
                    Run{"sideways", "bit-b-sideways.toml", {coarse}},
                    Run{"a_leaning_bit", "bit-b-tilt.toml", {coarse, "time.revolutions=4"}},
                    Run{"spalling",
                        "bit-b-3000psi.toml",
                        {coarse, "rock.pressure=0", "time.revolutions=4",
                         "spalling={angle='70 deg', ahead_share=0.3}"}},
                    Run{"reaming", "bit-b-ream.toml", {coarse}},
                    Run{"a_rough_start", "bit-b-rough.toml", {coarse, "time.revolutions=4"}}),
    [](const auto& instance) { return instance.param.name; });

/// Once the bit stands still nothing waits any more.
TEST(StandingStill, ends_all_rests_of_maintenance) {
  const Case c = read_case(TDBD_SOURCE_DIR "/cases/core.toml",
                           {"rock.edge_length='3 mm'", "time.revolutions=2"});
  Simulation s = start(c);
  for (int i = 0; i < 200; ++i) step(c, s);
  EXPECT_FALSE(s.state.rock.touched_list.empty());
  const Pose X_WB = over_rock(s.state.place);
  for (long i = 0; i < c.maintenance.rest + 2 * c.maintenance.every; ++i) {
    rock::cut_rock(s.state.rock, s.work.cutting, X_WB, X_WB, s.work.cut_work, s.state.cut);
    ++s.state.steps_done;
    maintain(c, s.state, s.work);
  }
  EXPECT_TRUE(s.state.rock.touched_list.empty());
}

/// Trimming keeps a disc and the ledger; the wall does not grow.
TEST(TrimmedWall, keeps_the_disc_and_the_ledger_and_a_bounded_number_of_triangles) {
  const std::string file = TDBD_SOURCE_DIR "/cases/core.toml";
  const std::vector<std::string> common{"rock.edge_length='4 mm'", "time.revolutions=40",
                                        "time.step='2 ms'"};
  std::vector<std::string> trimmed = common;
  trimmed.emplace_back("rock.trim='80 mm'");
  std::array<long, 2> triangles{};
  for (const bool trims : {false, true}) {
    const Case c = read_case(file, trims ? trimmed : common);
    Simulation s = start(c);
    while (s.state.steps_done < c.time.steps) step(c, s);
    EXPECT_LE(ledger_defect(s), tolerance::ledger);
    EXPECT_EQ(rock::describe(rock::check_disc(s.state.rock)), "");
    EXPECT_EQ(s.state.trimming.triangles > 0, trims);
    triangles.at(trims ? 1 : 0) = s.state.rock.surface.triangle_count();
  }
  fmt::print("{} triangles with the whole wall, {} when trimmed\n", triangles[0], triangles[1]);
  EXPECT_LT(triangles[1], triangles[0]);
}

TEST(TrimmedWall, is_rejected_below_what_cuts) {
  const Case c = read_case(TDBD_SOURCE_DIR "/cases/core.toml", {"rock.trim='20 mm'"});
  try {
    start(c);
    FAIL() << "expected an InputError";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("rock.trim: found 20 mm"), std::string::npos) << e.what();
  }
}

}  // namespace tdbd::simulation::stable_surface_test
