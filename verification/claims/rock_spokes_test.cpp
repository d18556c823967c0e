#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "battery/evidence.hpp"
#include "claims/spoke_runs.hpp"
#include "reference/bit/scalloped_wall.hpp"

/// Figure 2.1 of the thesis in numbers: 120 spokes, Langeveld's and Hanson and Hansen's, with as
/// many nodes as our mesh has points, all against a fine height field, after one revolution.
namespace tdbd::claims::rock_spokes_test {

constexpr double mm = 1e-3, edge_length = 1.4 * mm, fine_cell = 0.3 * mm;
constexpr int spoke_count = 120;
const std::vector<double> rings{2 * mm,  20 * mm, 40 * mm,  60 * mm,
                                80 * mm, 90 * mm, 100 * mm, 106 * mm};

/// A row for each ring, lengths in mm.
nlohmann::ordered_json table(const SpokeDrilling& d, const SpokeErrors& e) {
  nlohmann::ordered_json rows;
  for (std::size_t i = 0; i < e.mesh.size(); ++i) {
    const auto &m = e.mesh[i], &l = e.langeveld[i], &h = e.hanson[i];
    const double r = 0.5 * (m.r_lo + m.r_hi), spread = reference::spoke_spacing(d.langeveld, r),
                 even = mesh_spacing(d, m.r_lo, m.r_hi);
    rows.push_back({{"r_mm", r / mm},
                    {"mesh_spacing_mm", even / mm},
                    {"spoke_spacing_mm", spread / mm},
                    {"node_spacing_mm", d.langeveld.node_spacing() / mm},
                    {"mesh_error_mm", m.mean / mm},
                    {"spoke_error_mm", l.mean / mm},
                    {"outline_error_mm", h.mean / mm},
                    {"mesh_p95_mm", m.p95 / mm},
                    {"spoke_p95_mm", l.p95 / mm},
                    {"outline_p95_mm", h.p95 / mm}});
    fmt::print(
        "r {:5.1f}: spacing mesh {:.2f}, spokes {:.2f} mm; mean (p95) error mesh {:.4f} ({:.3f}), "
        "Langeveld {:.4f} ({:.3f}), Hanson and Hansen {:.4f} ({:.3f}) mm\n",
        r / mm, even / mm, spread / mm, m.mean / mm, m.p95 / mm, l.mean / mm, l.p95 / mm,
        h.mean / mm, h.p95 / mm);
  }
  return rows;
}

void print_points(const SpokeDrilling& d) {
  fmt::print("points: mesh {}, Langeveld {}, Hanson and Hansen {} now\n", d.points,
             d.langeveld.depth.size(), nodes_inside(d.hanson, d.plan.bit));
}

/// Steady drilling leaves almost a surface of revolution: few spokes and many nodes are then the
/// better use of points, but for the steps in front of the cutters.
TEST(Spokes, spread_towards_the_gage_where_the_mesh_stays_even) {
  const SpokeDrilling d =
      drill_spokes(spoke_plan(edge_length, {"time.step=4 ms"}), spoke_count, fine_cell);
  print_points(d);
  const auto rows = table(d, spoke_errors(d, rings));
  battery::record_table("spokes-steady", rows);
  const auto mm_at = [&](std::size_t i, const char* key) { return rows[i][key].get<double>(); };
  const std::size_t last = rows.size() - 1;
  EXPECT_GT(mm_at(last, "spoke_spacing_mm"), 9.0 * mm_at(0, "spoke_spacing_mm"));
  EXPECT_LT(mm_at(last, "mesh_spacing_mm"), 1.5 * mm_at(0, "mesh_spacing_mm"));
}

TEST(Spokes, lose_a_whirling_bits_pattern_at_the_gage_that_the_mesh_shows) {
  const SpokeDrilling d =
      drill_spokes(spoke_plan(edge_length, spoke_whirl()), spoke_count, fine_cell);
  print_points(d);
  const SpokeErrors e = spoke_errors(d, rings);
  battery::record_table("spokes-whirl", table(d, e));
  for (const auto* spokes : {&e.langeveld, &e.hanson}) {
    EXPECT_GT(spokes->back().mean, 2.0 * e.mesh.back().mean);
    EXPECT_GT(spokes->back().mean, spokes->front().mean);
  }
}

/// The second revolution of steady drilling on spokes alone. The cusps that hang over between two
/// passes of the gage's cutters stay, so that what is removed is what lies within the scalloped
/// wall and less than pi R^2 d. What respacing cuts off the cusps is not removed by the bit.
TEST(Spokes, remove_in_a_revolution_what_lies_within_the_scalloped_wall) {
  const simulation::Case plan = spoke_plan(edge_length, {});
  const mesh::TriangleMesh start_W = mesh::compact(simulation::start(plan).state.rock.surface);
  constexpr int few = 12;
  constexpr double spacing = 1.0 * mm;
  reference::OutlineSpokes rock = hanson_of(start_W, plan.bit, few, spacing);
  const long turn = plan.time.steps;
  drill_hanson(rock, plan, 0, turn);
  const reference::OutlineCut revolution = drill_hanson(rock, plan, turn, 2 * turn);
  const double r = plan.bit.gage_radius,
               advance =
                   plan.motion.rate_of_penetration * plan.time.step * static_cast<double>(turn),
               cylinder = std::numbers::pi * r * r * advance,
               wall = reference::scalloped_wall(plan.bit, advance, 1000).volume;
  fmt::print("over pi R^2 d: wall {:.5f}, removed {:.5f}, respaced {:.5f}\n", wall / cylinder,
             revolution.removed / cylinder, revolution.respaced / cylinder);
  constexpr double asked_of_our_mesh = 5e-4;
  EXPECT_NEAR((revolution.removed - revolution.respaced) / wall, 1.0, asked_of_our_mesh);
  EXPECT_LT(revolution.removed, cylinder);
}

}  // namespace tdbd::claims::rock_spokes_test
