// The standard workload in our mesh, in height fields and on spokes, in one run.
// With --benchmark_enable_random_interleaving=true the repetitions of all take turns.

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/drilling.hpp"
#include "benchmarks/rival_drilling.hpp"

namespace tdbd::bench {
namespace {

constexpr double mm = 1e-3;
constexpr const char* workload = "standard-workload";

/// A height field and spokes measure volumes only; the case has sections and contact areas, too.
enum class Measured { volumes, all };

/// Drilled once for all repetitions, which go on from where the one before stopped.
Drilling& mesh_of(double edge_length, Measured measured = Measured::all) {
  static std::map<std::pair<double, Measured>, Drilling> all;
  const std::pair key{edge_length, measured};
  const auto known = all.find(key);
  if (known != all.end()) return known->second;
  std::vector<std::string> settings;
  if (measured == Measured::volumes) settings = {"measure.section='off'", "measure.contact='off'"};
  return all.emplace(key, after_one_revolution(workload, edge_length, settings)).first->second;
}

RivalDrilling<reference::ZMap>& field_of(double cell) {
  static std::map<double, RivalDrilling<reference::ZMap>> all;
  const auto known = all.find(cell);
  if (known != all.end()) return known->second;
  const simulation::Case& plan = mesh_of(1.0 * mm).plan;
  RivalDrilling<reference::ZMap> f = start_z_map(plan, cell);
  drill(f, steps_of_a_revolution(plan));
  return all.emplace(cell, std::move(f)).first->second;
}

/// One iteration is one step with its volumes, ledger and share of maintenance.
void mesh_step(benchmark::State& state, double edge_length, Measured measured) {
  Drilling& d = mesh_of(edge_length, measured);
  for (auto _ : state) drill(d, 1);
}

/// One iteration is one step with its volume; volumes by cutter cost nothing more.
void z_map_step(benchmark::State& state, double cell) {
  RivalDrilling<reference::ZMap>& f = field_of(cell);
  for (auto _ : state) drill(f, 1);
}

/// Langeveld's 120 spokes of 500 nodes.
void spokes_step(benchmark::State& state) {
  const simulation::Case& plan = mesh_of(1.0 * mm).plan;
  static RivalDrilling<reference::Spokes> rival = start_spokes(plan, 120, 500);
  for (auto _ : state) drill(rival, 1);
}

/// 100 steps are 20 maintenances of ours.
void turns(benchmark::internal::Benchmark* b) {
  b->Unit(benchmark::kMicrosecond)->Iterations(100)->Repetitions(15)->ReportAggregatesOnly();
}

BENCHMARK_CAPTURE(mesh_step, 1_mm, 1.0 * mm, Measured::all)->Apply(turns);
BENCHMARK_CAPTURE(mesh_step, 0_7_mm, 0.7 * mm, Measured::all)->Apply(turns);
BENCHMARK_CAPTURE(mesh_step, 1_mm_volumes, 1.0 * mm, Measured::volumes)->Apply(turns);
BENCHMARK_CAPTURE(mesh_step, 0_7_mm_volumes, 0.7 * mm, Measured::volumes)->Apply(turns);
BENCHMARK_CAPTURE(z_map_step, 1_mm, 1.0 * mm)->Apply(turns);
BENCHMARK_CAPTURE(z_map_step, 0_5_mm, 0.5 * mm)->Apply(turns);
BENCHMARK_CAPTURE(z_map_step, 0_25_mm, 0.25 * mm)->Apply(turns);
BENCHMARK(spokes_step)->Apply(turns);

}  // namespace
}  // namespace tdbd::bench
