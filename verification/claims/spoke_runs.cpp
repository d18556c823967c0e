#include "claims/spoke_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/literature/surface/z_map_sweep.hpp"

namespace tdbd::claims {
namespace {

using reference::OutlineSpokes;
using reference::Spokes;
using reference::ZMap;

constexpr double mm = 1e-3;
constexpr double margin = 12 * mm, below_bottom = 30 * mm;
constexpr double rim = 0.1 * mm;  ///< points of the wall are at the gage to within this

double inside_gage(const bit::Bit& bit) { return bit.gage_radius - rim; }

ZMap at_cells_of(const ZMap& fine, const Spokes& spokes) {
  ZMap map = fine;
  for (int row = 0; row < map.cells; ++row)
    for (int column = 0; column < map.cells; ++column)
      map.height[static_cast<std::size_t>(row * map.cells + column)] = reference::depth_at(
          spokes, (column + 0.5) * map.cell() - map.half, (row + 0.5) * map.cell() - map.half);
  return map;
}

/// The bit at a step's end, and at its start in the frame of its end.
struct Step {
  Pose X_WB1, X_B1B0;
};

Step step_of(const simulation::Case& c, long i) {
  const double t = c.time.step * static_cast<double>(i);
  const Pose X_WB1 = simulation::pose_at(c.motion, t + c.time.step);
  return {X_WB1, inverse(X_WB1) * simulation::pose_at(c.motion, t)};
}

/// The spacing with which a drilled spoke has so many nodes within the gage, by trial on a few
/// spokes.
double spacing_for(const simulation::Case& c, const mesh::TriangleMesh& start_W, double nodes) {
  constexpr int few = 6, trials = 3;
  double spacing = c.bit.gage_radius / nodes, best = spacing, least = INFINITY;
  for (int trial = 0; trial < trials; ++trial) {
    OutlineSpokes rock = hanson_of(start_W, c.bit, few, spacing);
    drill_hanson(rock, c, 0, c.time.steps);
    const double over = static_cast<double>(nodes_inside(rock, c.bit)) / (few * nodes);
    if (std::abs(over - 1.0) < least) least = std::abs(over - 1.0), best = spacing;
    spacing *= over;
  }
  return best;
}

}  // namespace

simulation::Case spoke_plan(double edge_length, const std::vector<std::string>& settings) {
  std::vector<std::string> all{fmt::format("rock.edge_length={}", edge_length), "rock.wall=20 mm",
                               "time.step=2 ms", "time.revolutions=1"};
  all.insert(all.end(), settings.begin(), settings.end());
  return simulation::read_case(TDBD_SOURCE_DIR "/cases/standard-workload.toml", all);
}

OutlineSpokes hanson_of(const mesh::TriangleMesh& rock_W, const bit::Bit& bit, int spokes,
                        double spacing) {
  double bottom = 0.0;
  for (const Vec3& x : rock_W.positions) bottom = std::max(bottom, x.z());
  return reference::outline_spokes_of(rock_W, {bit.gage_radius + margin, bottom + below_bottom},
                                      spokes, spacing);
}

reference::OutlineCut drill_hanson(OutlineSpokes& rock, const simulation::Case& plan, long first,
                                   long last) {
  constexpr int at_once = 20;
  const auto hulls = reference::cutter_hulls(plan.bit);
  reference::OutlineCut sum;
  reference::SpokeSections sections;
  for (long i = first; i < last; ++i) {
    const Step step = step_of(plan, i);
    reference::add_sections(sections, rock, reference::swept_bodies(hulls, step.X_B1B0),
                            step.X_WB1);
    if ((i + 1) % at_once != 0 && i + 1 < last) continue;
    const reference::OutlineCut cut = reference::cut_sections(rock, sections);
    sum.removed += cut.removed;
    sum.respaced += cut.respaced;
  }
  return sum;
}

long nodes_inside(const OutlineSpokes& rock, const bit::Bit& bit) {
  return reference::nodes_within(rock, inside_gage(bit));
}

std::vector<std::string> spoke_whirl() {
  return {"motion.kind=whirl", "motion.whirl.radius=3 mm", "motion.whirl.frequency=840 rpm",
          "motion.whirl.sense=backward"};
}

long points_within(const mesh::TriangleMesh& m, double r_lo, double r_hi) {
  return std::count_if(m.positions.begin(), m.positions.end(), [&](const Vec3& x) {
    return x.head<2>().norm() >= r_lo && x.head<2>().norm() < r_hi;
  });
}

SpokeDrilling drill_spokes(const simulation::Case& plan, int spokes, double fine_cell) {
  simulation::Simulation s = simulation::start(plan);
  SpokeDrilling d;
  d.plan = plan;
  const mesh::TriangleMesh start_W = mesh::compact(s.state.rock.surface);
  const double gage = plan.bit.gage_radius, half = gage + margin;
  d.points = points_within(start_W, 0.0, inside_gage(plan.bit));
  d.fine = reference::z_map_of(start_W, half, static_cast<int>(std::lround(2 * half / fine_cell)));
  d.langeveld = reference::spokes_of(start_W, gage, spokes, static_cast<int>(d.points / spokes));
  d.hanson = hanson_of(
      start_W, plan.bit, spokes,
      spacing_for(plan, start_W, static_cast<double>(d.points) / static_cast<double>(spokes)));
  d.hanson_cut = drill_hanson(d.hanson, plan, 0, plan.time.steps);
  const auto hulls = reference::cutter_hulls(plan.bit);
  for (long i = 0; i < plan.time.steps; ++i) {
    const Step step = step_of(plan, i);
    const auto tools = reference::ruled_tools(hulls, step.X_B1B0);
    reference::cut_sweep(d.fine, tools, step.X_WB1);
    reference::cut_sweep(d.langeveld, tools, step.X_WB1);
    simulation::step(plan, s);
  }
  d.mesh_W = mesh::compact(s.state.rock.surface);
  d.mesh_removed = s.state.ledger.removed.value();
  return d;
}

SpokeErrors spoke_errors(const SpokeDrilling& d, const std::vector<double>& radii) {
  const auto cosine = reference::profile_cosine(d.plan.bit);
  const auto errors = [&](const ZMap& map) {
    return reference::surface_errors(d.fine, map, cosine, radii);
  };
  constexpr int nodes_seen = 1000;  // far finer than any node
  return {
      errors(reference::z_map_of(d.mesh_W, d.fine.half, d.fine.cells)),
      errors(at_cells_of(d.fine, d.langeveld)),
      errors(at_cells_of(d.fine, reference::deepest(d.hanson, d.hanson.frame.radius, nodes_seen)))};
}

double mesh_spacing(const SpokeDrilling& d, double r_lo, double r_hi) {
  const double r = 0.5 * (r_lo + r_hi);
  const double area =
      std::numbers::pi * (r_hi * r_hi - r_lo * r_lo) / reference::profile_cosine(d.plan.bit).at(r);
  const auto points = static_cast<double>(points_within(d.mesh_W, r_lo, r_hi));
  return std::sqrt(2.0 / std::sqrt(3.0) * area / points);
}

}  // namespace tdbd::claims
