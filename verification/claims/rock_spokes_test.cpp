#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "claims/example_bits.hpp"
#include "reference/rock/spokes.hpp"
#include "reference/rock/surface_error.hpp"
#include "reference/rock/z_map_sweep.hpp"
#include "simulation/simulation.hpp"

/// Figure 2.1 of the thesis in numbers: Langeveld's 120 spokes with as many nodes as our mesh has
/// points, both against a fine height field, after one revolution of the standard workload.
namespace tdbd::claims {
namespace {

using reference::Spokes;
using reference::SurfaceError;
using reference::ZMap;

constexpr double mm = 1e-3;
constexpr double edge_length = 1.4 * mm, fine_cell = 0.2 * mm, map_margin = 12 * mm;
constexpr int langeveld = 120;
const std::vector<double> rings{2 * mm,  20 * mm, 40 * mm,  60 * mm,
                                80 * mm, 90 * mm, 100 * mm, 106 * mm};

simulation::Case plan_of(std::vector<std::string> settings) {
  settings.insert(settings.end(), {fmt::format("rock.edge_length={}", edge_length),
                                   "rock.wall=20 mm", "time.step=2 ms", "time.revolutions=1"});
  return simulation::read_case(TDBD_SOURCE_DIR "/cases/standard-workload.toml", settings);
}

/// The same revolution in three kinds of rock. Each starts from our surface at t = 0.
struct Drilled {
  bit::Bit bit;
  mesh::TriangleMesh mesh_W;
  ZMap fine;
  Spokes spokes;
};

long points_within(const mesh::TriangleMesh& m, double r_lo, double r_hi) {
  return std::count_if(m.positions.begin(), m.positions.end(), [&](const Vec3& x) {
    return x.head<2>().norm() >= r_lo && x.head<2>().norm() < r_hi;
  });
}

Drilled drill(const simulation::Case& c) {
  simulation::Simulation s = simulation::start(c);
  Drilled d;
  d.bit = c.bit;
  const mesh::TriangleMesh start_W = mesh::compact(s.rock.surface);
  const double half = c.bit.gage_radius + map_margin, gage = c.bit.gage_radius;
  d.fine = reference::z_map_of(start_W, half, static_cast<int>(std::lround(2 * half / fine_cell)));
  const long points = points_within(start_W, 0.0, gage - 0.1 * mm);
  d.spokes = reference::spokes_of(start_W, gage, langeveld, static_cast<int>(points / langeveld));
  const auto hulls = reference::cutter_hulls(c.bit);
  for (long i = 0; i < c.time.steps; ++i) {
    const double t = c.time.step * static_cast<double>(i);
    const Pose X_WB0 = simulation::pose_at(c.motion, t),
               X_WB1 = simulation::pose_at(c.motion, t + c.time.step);
    const auto tools = reference::ruled_tools(hulls, inverse(X_WB1) * X_WB0);
    reference::cut_sweep(d.fine, tools, X_WB1);
    reference::cut_sweep(d.spokes, tools, X_WB1);
    simulation::step(c, s);
  }
  d.mesh_W = mesh::compact(s.rock.surface);
  return d;
}

ZMap at_cells_of(const ZMap& fine, const Spokes& spokes) {
  ZMap map = fine;
  for (int row = 0; row < map.cells; ++row)
    for (int column = 0; column < map.cells; ++column)
      map.height[static_cast<std::size_t>(row * map.cells + column)] = reference::depth_at(
          spokes, (column + 0.5) * map.cell() - map.half, (row + 0.5) * map.cell() - map.half);
  return map;
}

struct Errors {
  std::vector<SurfaceError> mesh, spokes;
};

Errors errors_of(const Drilled& d) {
  const auto cosine = reference::profile_cosine(d.bit);
  const ZMap mesh = reference::z_map_of(d.mesh_W, d.fine.half, d.fine.cells);
  return {reference::surface_errors(d.fine, mesh, cosine, rings),
          reference::surface_errors(d.fine, at_cells_of(d.fine, d.spokes), cosine, rings)};
}

/// Mean distance between neighbouring points of the mesh in a ring, as of equilateral triangles.
double mesh_spacing(const Drilled& d, const SurfaceError& ring) {
  const double r = 0.5 * (ring.r_lo + ring.r_hi);
  const double area = std::numbers::pi * (ring.r_hi * ring.r_hi - ring.r_lo * ring.r_lo) /
                      reference::profile_cosine(d.bit).at(r);
  const auto points = static_cast<double>(points_within(d.mesh_W, ring.r_lo, ring.r_hi));
  return std::sqrt(2.0 / std::sqrt(3.0) * area / points);
}

/// A row for each ring, lengths in mm.
nlohmann::ordered_json table(const Drilled& d, const Errors& e) {
  nlohmann::ordered_json rows;
  for (std::size_t i = 0; i < e.mesh.size(); ++i) {
    const SurfaceError &m = e.mesh[i], &s = e.spokes[i];
    const double r = 0.5 * (m.r_lo + m.r_hi), spread = reference::spoke_spacing(d.spokes, r);
    rows.push_back({{"r_mm", r / mm},
                    {"mesh_spacing_mm", mesh_spacing(d, m) / mm},
                    {"spoke_spacing_mm", spread / mm},
                    {"node_spacing_mm", d.spokes.node_spacing() / mm},
                    {"mesh_error_mm", m.mean / mm},
                    {"spoke_error_mm", s.mean / mm},
                    {"mesh_p95_mm", m.p95 / mm},
                    {"spoke_p95_mm", s.p95 / mm},
                    {"mesh_volume_mm3", m.volume / (mm * mm * mm)},
                    {"spoke_volume_mm3", s.volume / (mm * mm * mm)}});
    fmt::print(
        "r {:5.1f}: spacing mesh {:.2f}, spokes {:.2f} x {:.2f} mm; error mesh {:.4f} ({:.3f}), "
        "spokes {:.4f} ({:.3f}) mm, volume {:+.0f} {:+.0f} mm3\n",
        r / mm, mesh_spacing(d, m) / mm, spread / mm, d.spokes.node_spacing() / mm, m.mean / mm,
        m.p95 / mm, s.mean / mm, s.p95 / mm, 1e9 * m.volume, 1e9 * s.volume);
  }
  return rows;
}

/// Steady drilling leaves almost a surface of revolution: few spokes and many nodes are then the
/// better use of points, but for the steps in front of the cutters.
TEST(Spokes, spread_towards_the_gage_where_the_mesh_stays_even) {
  const Drilled d = drill(plan_of({}));
  const auto rows = table(d, errors_of(d));
  battery::record_table("spokes-steady", rows);
  const auto mm_at = [&](std::size_t i, const char* key) { return rows[i][key].get<double>(); };
  const std::size_t last = rows.size() - 1;
  EXPECT_GT(mm_at(last, "spoke_spacing_mm"), 9.0 * mm_at(0, "spoke_spacing_mm"));
  EXPECT_LT(mm_at(last, "mesh_spacing_mm"), 1.5 * mm_at(0, "mesh_spacing_mm"));
}

TEST(Spokes, lose_a_whirling_bits_pattern_at_the_gage_that_the_mesh_shows) {
  const Drilled d =
      drill(plan_of({"motion.kind=whirl", "motion.whirl.radius=3 mm",
                     "motion.whirl.frequency=840 rpm", "motion.whirl.sense=backward"}));
  const Errors e = errors_of(d);
  battery::record_table("spokes-whirl", table(d, e));
  EXPECT_GT(e.spokes.back().mean, 2.0 * e.mesh.back().mean);
  EXPECT_GT(e.spokes.back().mean, e.spokes.front().mean);
}

}  // namespace
}  // namespace tdbd::claims
