#include "benchmarks/rival_drilling.hpp"

#include <cmath>

namespace tdbd::bench {
namespace {

constexpr double margin = 4e-3;       // m, of the map beyond the gage
constexpr double deepest_cut = 3e-3;  // m: no cutter of the standard workload cuts deeper

reference::SteadyDrilling drilling_of(const simulation::Case& plan) {
  return reference::steady_drilling(plan.bit, simulation::angle_turned(plan.motion, plan.time.step),
                                    plan.motion.rate_of_penetration * plan.time.step, deepest_cut);
}

mesh::TriangleMesh rock_at_start(const simulation::Case& plan) {
  return mesh::compact(simulation::start(plan).state.rock.surface);
}

}  // namespace

RivalDrilling<reference::ZMap> start_z_map(const simulation::Case& plan, double cell) {
  const double half = plan.bit.gage_radius + margin;
  const int cells = static_cast<int>(std::lround(2.0 * half / cell));
  return {drilling_of(plan), reference::z_map_of(rock_at_start(plan), half, cells)};
}

RivalDrilling<reference::Spokes> start_spokes(const simulation::Case& plan, int spokes, int nodes) {
  return {drilling_of(plan),
          reference::spokes_of(rock_at_start(plan), plan.bit.gage_radius, spokes, nodes)};
}

}  // namespace tdbd::bench
