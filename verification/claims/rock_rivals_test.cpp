#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "claims/example_bits.hpp"
#include "core/observed_order.hpp"
#include "reference/bit/scalloped_wall.hpp"
#include "reference/literature/surface/steady_drilling.hpp"
#include "reference/literature/surface/surface_error.hpp"
#include "reference/literature/surface/z_map_sweep.hpp"
#include "simulation/step/simulation.hpp"

/// The standard workload after one revolution: our mesh and height fields against a fine height
/// field; and the volume of later revolutions against the closed form.
namespace tdbd::claims::rock_rivals_test {

using reference::SurfaceError;
using reference::ZMap;

constexpr double mm = 1e-3, mm3 = 1e-9;
constexpr double fine_cell = 0.1 * mm;  ///< its own error is below 1 micrometre in the mean
constexpr double map_margin = 4 * mm, deepest_cut = 3 * mm;
constexpr long turn_steps = 500;

simulation::Case plan_of(double edge_length) {
  return simulation::read_case(TDBD_SOURCE_DIR "/cases/standard-workload.toml",
                               {fmt::format("rock.edge_length={}", edge_length)});
}

const simulation::Case& plan() {
  static const simulation::Case c = plan_of(1.0 * mm);
  return c;
}

double half_of_map() { return plan().bit.gage_radius + map_margin; }
int cells_of(double cell) { return static_cast<int>(std::lround(2.0 * half_of_map() / cell)); }

double advance() { return plan().motion.rate_of_penetration * plan().time.step * turn_steps; }

double expected_volume() {
  const double r = plan().bit.gage_radius;
  return std::numbers::pi * r * r * advance();
}

mesh::TriangleMesh rock_at_start() {
  static const mesh::TriangleMesh rock =
      mesh::compact(simulation::start(plan()).state.rock.surface);
  return rock;
}

/// A rival's rock after the first revolution.
template <class Rock>
Rock drilled(Rock rock) {
  auto d = reference::steady_drilling(
      plan().bit, simulation::angle_turned(plan().motion, plan().time.step),
      plan().motion.rate_of_penetration * plan().time.step, deepest_cut);
  reference::drill(d, rock, turn_steps);
  return rock;
}

ZMap z_map(double cell) {
  return drilled(reference::z_map_of(rock_at_start(), half_of_map(), cells_of(cell)));
}

const ZMap& fine() {
  static const ZMap map = z_map(fine_cell);
  return map;
}

/// Our rock after the first revolution, at the fine map's cells.

ZMap ours(double edge_length) {
  const simulation::Case c = plan_of(edge_length);
  simulation::Simulation s = simulation::start(c);
  for (long i = 0; i < turn_steps; ++i) simulation::step(c, s);
  return reference::z_map_of(mesh::compact(s.state.rock.surface), half_of_map(), fine().cells);
}

/// Without the axis and the gage's edge, where depths are no distances.
SurfaceError whole(const ZMap& surface) {
  return reference::surface_errors(fine(), surface, reference::profile_cosine(plan().bit),
                                   {2 * mm, 106 * mm})
      .front();
}

void print(const char* name, const SurfaceError& e) {
  fmt::print("{:18} mean {:.4f} mm, p95 {:.4f}, p99 {:.4f}, signed {:+.4f}, volume {:+.1f} mm3\n",
             name, e.mean / mm, e.p95 / mm, e.p99 / mm, e.mean_signed / mm, e.volume / mm3);
}

nlohmann::ordered_json row(const std::string& name, const SurfaceError& e) {
  print(name.c_str(), e);
  return {{"surface", name},
          {"mean_mm", e.mean / mm},
          {"p95_mm", e.p95 / mm},
          {"p99_mm", e.p99 / mm},
          {"mean_signed_mm", e.mean_signed / mm},
          {"volume_mm3", e.volume / mm3}};
}

TEST(RockRivals, surface_of_1_mm_edges_is_within_20_micrometres_of_the_fine_height_field) {
  const SurfaceError e = whole(ours(1.0 * mm));
  battery::record_table("surface-error", {row("mesh 1.0 mm", e)});
  EXPECT_LE(e.mean, 0.02 * mm);
  EXPECT_LE(e.p95, 0.06 * mm);
}

TEST(RockRivals, mesh_of_0_7_mm_equals_the_height_field_of_0_5_mm_cells) {
  const SurfaceError mesh = whole(ours(0.7 * mm)),
                     map = whole(reference::resampled(z_map(0.5 * mm), fine()));
  battery::record_table("surface-error-equal",
                        {row("mesh 0.7 mm", mesh), row("z-map 0.5 mm", map)});
  EXPECT_LE(mesh.mean, 1.15 * map.mean);
  EXPECT_LE(mesh.p95, 1.15 * map.p95);
}

/// Errors of a revolution's volume, of the second to the fourth, over the exact one.
std::vector<double> volume_errors(double edge_length, double exact) {
  const simulation::Case c = plan_of(edge_length);
  simulation::Simulation s = simulation::start(c);
  for (long i = 0; i < 4 * turn_steps; ++i) simulation::step(c, s);
  std::vector<double> errors;
  for (std::size_t k = 1; k < 4; ++k) {
    const std::vector<double>& parts = s.state.ledger.removed_by_revolution[k];
    errors.push_back(std::accumulate(parts.begin(), parts.end(), 0.0) / exact - 1.0);
  }
  return errors;
}

double mean(const std::vector<double>& x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

double rms(const std::vector<double>& x) {
  return std::sqrt(std::inner_product(x.begin(), x.end(), x.begin(), 0.0) /
                   static_cast<double>(x.size()));
}

/// Whatever the bottom's shape, a revolution of steady drilling removes what lies within the wall.
/// Our mesh keeps the cusps between two passes of the gage's cutters as far as its edges show them.
TEST(RockRivals, volume_of_a_revolution_converges_to_that_within_the_scalloped_wall) {
  const double exact = reference::scalloped_wall(plan().bit, advance(), 1000).volume;
  fmt::print("scalloped wall: {:+.4f} % of pi R^2 d\n", 100 * (exact / expected_volume() - 1));
  const std::vector<double> edges{4.0, 2.8, 2.0, 1.4, 1.0};
  std::vector<double> errors;
  nlohmann::ordered_json rows;
  for (const double edge : edges) {
    const std::vector<double> e = volume_errors(edge * mm, exact);
    errors.push_back(rms(e));
    fmt::print("edges {:.1f} mm: {:+.3f} {:+.3f} {:+.3f} %, mean {:+.3f} %, rms {:.3f} %\n", edge,
               100 * e[0], 100 * e[1], 100 * e[2], 100 * mean(e), 100 * rms(e));
    rows.push_back({{"edge_mm", edge}, {"mean", mean(e)}, {"rms", rms(e)}});
  }
  battery::record_table("volume-of-a-revolution", rows);
  const double order = least_squares_order(edges, errors);
  fmt::print("observed order {:.2f}\n", order);
  EXPECT_GE(order, 1.0);
  EXPECT_LE(std::abs(rows.back()["mean"].get<double>()), 5e-4);
  EXPECT_LE(errors.back(), 1.2e-3);
}

}  // namespace tdbd::claims::rock_rivals_test
