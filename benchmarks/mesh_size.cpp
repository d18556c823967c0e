// The same cutting in rock of increasing size, and with decreasing edge length: run time of a step,
// and which part of it grows with the rock or with the touched vertices.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "benchmarks/drilling.hpp"

namespace tdbd::bench {
namespace {

constexpr double mm = 1e-3;

void drill_and_report(benchmark::State& state, Drilling& d) {
  long moved = 0;
  const double start = cpu_seconds();
  for (auto _ : state) {
    drill(d, 1);
    moved += d.run.state.cut.moved;
  }
  const double seconds = cpu_seconds() - start;
  state.counters["triangles"] = static_cast<double>(d.run.state.rock.surface.triangle_count());
  state.counters["moves"] = static_cast<double>(moved) / static_cast<double>(state.iterations());
  state.counters["ns_a_move"] = 1e9 * seconds / static_cast<double>(moved);
}

/// The standard workload with 1.6 mm edges and a wall of this height in mm.
void wall(benchmark::State& state) {
  Drilling d = after_one_revolution("standard-workload", 1.6 * mm,
                                    {fmt::format("rock.wall={} mm", state.range(0))});
  drill_and_report(state, d);
}

/// The standard workload with edges of this length in tenths of a millimetre.
void edges(benchmark::State& state) {
  Drilling d =
      after_one_revolution("standard-workload", 0.1 * mm * static_cast<double>(state.range(0)));
  drill_and_report(state, d);
}

/// Median of five repetitions, each the same 200 steps.
void repeat(benchmark::internal::Benchmark* b) {
  b->Unit(benchmark::kMicrosecond)->Iterations(200)->Repetitions(5)->ReportAggregatesOnly();
}

BENCHMARK(wall)->Apply(repeat)->Arg(6)->Arg(100)->Arg(300)->Arg(900)->Arg(3200);
BENCHMARK(edges)->Apply(repeat)->Arg(40)->Arg(28)->Arg(20)->Arg(14)->Arg(10)->Arg(7);

}  // namespace
}  // namespace tdbd::bench
