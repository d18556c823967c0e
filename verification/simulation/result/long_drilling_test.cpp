#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/tolerance.hpp"
#include "mesh/check/check.hpp"
#include "mesh/measures.hpp"
#include "reference/mesh/self_intersections.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation::long_drilling_test {

constexpr double revolutions = 20;

/// Bit B for twenty revolutions on a coarse mesh: what maintenance must keep.
class TwentyRevolutions : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    case_ = new Case(read_case(TDBD_SOURCE_DIR "/cases/bit-b-steady.toml",
                               {"rock.edge_length='2.5 mm'", "time.revolutions=20",
                                // these have tests of their own, and take longer than the cut
                                "measure.section=off", "measure.contact=off"}));
    first_ = new mesh::Surface();
    simulation_ = new Simulation(start(*case_));
    *first_ = simulation_->state.rock.surface;
    while (simulation_->state.steps_done < case_->time.steps) step(*case_, *simulation_);
  }
  static void TearDownTestSuite() {
    delete simulation_;
    delete first_;
    delete case_;
  }
  static const mesh::Surface& surface() { return simulation_->state.rock.surface; }
  static double advance() {
    return case_->motion.rate_of_penetration * 2.0 * std::numbers::pi / case_->motion.rotary_speed;
  }

  static inline Case* case_ = nullptr;
  static inline mesh::Surface* first_ = nullptr;
  static inline Simulation* simulation_ = nullptr;
};

TEST_F(TwentyRevolutions, keep_the_surface_a_disc) {  // M1
  const mesh::TriangleMesh m = mesh::compact(surface());
  EXPECT_TRUE(mesh::adjacency_is_consistent(surface()));
  EXPECT_TRUE(mesh::check_surface(m).empty());
  const auto edges = (3 * m.triangles.size() +
                      static_cast<std::size_t>(std::ranges::count(surface().boundary, 1))) /
                     2;
  EXPECT_EQ(m.positions.size() + m.triangles.size(), edges + 1);
}

TEST_F(TwentyRevolutions, keep_edges_in_their_limits) {  // M3
  long too_long = 0, too_short = 0, all = 0;
  for (int c = 0; c < 3 * surface().triangle_slots(); ++c) {
    if (!surface().triangle_is_alive(c / 3)) continue;
    const int a = surface().vertex(mesh::next_corner(c)),
              b = surface().vertex(mesh::previous_corner(c));
    const double length = (surface().position(a) - surface().position(b)).norm();
    ++all;
    too_long += length > simulation_->work.limits.longest_edge;
    too_short += length < simulation_->work.limits.shortest_edge;
  }
  const long refused = rock::refusals(simulation_->state.maintenance);
  fmt::print("edges: {} too long, {} too short of {}; {} refusals\n", too_long / 2, too_short / 2,
             all / 2, refused);
  EXPECT_LE(too_long + too_short, refused);
}

TEST_F(TwentyRevolutions, close_the_ledger_and_hardly_disturb_it) {  // M5
  EXPECT_LE(ledger_defect(*simulation_), tolerance::ledger);
  const double removed = simulation_->state.ledger.removed.value();
  fmt::print("maintenance disturbed {:.2e} of what was removed\n",
             simulation_->state.maintenance.volume_disturbed / removed);
  EXPECT_LT(simulation_->state.maintenance.volume_disturbed, 9e-6 * removed);
}

/// The places of the boundary; in order, since renumbering gives its vertices other numbers.
std::vector<std::array<double, 3>> boundary_of(const mesh::Surface& s) {
  std::vector<std::array<double, 3>> places;
  for (int v = 0; v < s.vertex_slots(); ++v)
    if (s.is_alive(v) && s.is_boundary(v))
      places.push_back({s.position(v).x(), s.position(v).y(), s.position(v).z()});
  std::ranges::sort(places);
  return places;
}

TEST_F(TwentyRevolutions, leave_the_boundary_bitwise_identical) {  // M7
  EXPECT_EQ(boundary_of(surface()), boundary_of(*first_));
}

TEST_F(TwentyRevolutions, intersect_nothing) {  // M4
  EXPECT_EQ(reference::self_intersecting_pairs(mesh::compact(surface())), 0U);
}

TEST_F(TwentyRevolutions, need_no_more_triangles_than_the_wall_grows) {
  const double h = case_->rock.edge_length;
  const double wall = 2.0 * std::numbers::pi * case_->bit.gage_radius * revolutions * advance();
  const double for_wall = wall / (std::sqrt(0.1875) * h * h);
  const double at_start = first_->triangle_count(), at_end = surface().triangle_count();
  fmt::print("triangles: {} to {}, {:.0f} for the wall\n", at_start, at_end, for_wall);
  EXPECT_LE(at_end, 1.5 * at_start + for_wall);
}

TEST_F(TwentyRevolutions, remove_the_same_in_every_revolution_but_the_first) {
  const double r = case_->bit.gage_radius;
  const double expected = std::numbers::pi * r * r * advance();
  const auto& by_revolution = simulation_->state.ledger.removed_by_revolution;
  ASSERT_GE(by_revolution.size(), 20U);
  double worst = 0.0;
  for (std::size_t k = 1; k < 20; ++k) {
    const double removed = std::accumulate(by_revolution[k].begin(), by_revolution[k].end(), 0.0);
    worst = std::max(worst, std::abs(removed / expected - 1.0));
  }
  fmt::print("worst revolution: {:.3f} % from pi R^2 d at {:.1f} mm edges\n", 100 * worst,
             1e3 * case_->rock.edge_length);
  EXPECT_LT(worst, 0.01);
}

}  // namespace tdbd::simulation::long_drilling_test
