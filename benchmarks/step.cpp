// The kinematic step of shipped cases, and CGAL's corefinement on the standard workload.

#include <benchmark/benchmark.h>

#include <cmath>
#include <utility>
#include <vector>

#include "benchmarks/block.hpp"
#include "benchmarks/corefinement.hpp"
#include "benchmarks/drilling.hpp"

namespace tdbd::bench {
namespace {

constexpr double mm = 1e-3;

/// One iteration is one step with its volumes, ledger and share of maintenance.
void step(benchmark::State& state, const char* name, double edge_length) {
  Drilling d = after_one_revolution(name, edge_length);
  long moved = 0;
  for (auto _ : state) {
    drill(d, 1);
    moved += d.run.state.cut.moved;
  }
  state.counters["moves"] =
      benchmark::Counter(static_cast<double>(moved), benchmark::Counter::kAvgIterations);
  state.counters["triangles"] = static_cast<double>(d.run.state.rock.surface.triangle_count());
}

/// Corners of a cutter's disc in the cutter frame: those of its two rims, not of the mesh in
/// between.
std::vector<Vec3> disc_corners_C(const Drilling& d, int cutter) {
  const bit::Cutter& c = d.plan.bit.cutters[static_cast<std::size_t>(cutter)];
  const auto is_at = [](double x, double place) { return std::abs(x - place) < 1e-6 * mm; };
  std::vector<Vec3> corners;
  for (const bit::Part& part : d.plan.bit.parts)
    if (part.cutter == cutter)
      for (const Vec3& x : part.mesh_P.positions)
        if (is_at(x.tail<2>().norm(), 0.5 * c.diameter) &&
            (is_at(x.x(), 0.0) || is_at(x.x(), -c.length)))
          corners.push_back(x);
  return corners;
}

/// Corners of every cutter at both ends of the step after `steps` more steps. The hull begins a
/// twentieth of a step early, so that it does not share faces with the remaining rock.
std::vector<std::vector<Vec3>> swept_corners_W(const Drilling& d, long steps) {
  constexpr double overlap = 0.05;
  const int cutters = static_cast<int>(d.plan.bit.cutters.size());
  std::vector<std::vector<Vec3>> corners(d.plan.bit.cutters.size());
  for (int i = 0; i < cutters; ++i)
    for (const double at : {-overlap, 1.0}) {
      const Pose X_WC = pose_after(d, static_cast<double>(steps) + at) *
                        d.plan.bit.cutters[static_cast<std::size_t>(i)].X_BC;
      for (const Vec3& x_C : disc_corners_C(d, i))
        corners[static_cast<std::size_t>(i)].push_back(X_WC * x_C);
    }
  return corners;
}

mesh::TriangleMesh block_of(const Drilling& d) {
  constexpr double radius = 120 * mm, depth = 80 * mm;
  return block_of_rock(d.run.state.rock.surface, radius, depth);
}

/// Total run time and volume of one side.
struct Side {
  double cpu_seconds = 0.0;
  double removed = 0.0;  ///< m3
  long steps = 0;

  double milliseconds_a_step() const { return 1e3 * cpu_seconds / static_cast<double>(steps); }
  double removed_a_step() const { return removed / static_cast<double>(steps); }
};

void add(const BooleanCut& cut, Side& cgal) {
  cgal.cpu_seconds += cut.cpu_seconds;
  cgal.removed += cut.removed;
  ++cgal.steps;
}

/// Drills this number of steps. A multiple of the maintenance's period includes its proportional
/// share.
void add_steps(long steps, Drilling& d, Side& tdbd) {
  const double removed_before = d.run.state.ledger.removed.value();
  const double start = cpu_seconds();
  drill(d, steps);
  tdbd.cpu_seconds += cpu_seconds() - start;
  tdbd.removed += d.run.state.ledger.removed.value() - removed_before;
  tdbd.steps += steps;
}

void report(benchmark::State& state, const Side& cgal, const Side& tdbd) {
  state.counters["cgal_ms"] = cgal.milliseconds_a_step();
  state.counters["tdbd_ms"] = tdbd.milliseconds_a_step();
  state.counters["cgal/tdbd"] = cgal.milliseconds_a_step() / tdbd.milliseconds_a_step();
  state.counters["removed_cgal/tdbd"] = cgal.removed_a_step() / tdbd.removed_a_step();
}

/// Alternately, CGAL removes the next step from a copy of TDBD's rock, and TDBD drills to the next
/// maintenance. CGAL gets TDBD's mesh each time, so it never has to process the slivers that its
/// own results accumulate. The reported time is CGAL's.
void corefinement_of_our_rock(benchmark::State& state) {
  Drilling d = after_one_revolution("standard-workload", 1.0 * mm);
  Side cgal, tdbd;
  for (auto _ : state) {
    const BooleanCut cut = cut_by_corefinement(block_of(d), swept_corners_W(d, 0));
    add(cut, cgal);
    add_steps(d.plan.maintenance.every, d, tdbd);
    state.SetIterationTime(cut.cpu_seconds);
  }
  report(state, cgal, tdbd);
}

/// CGAL starts from TDBD's rock and continues with its own result, step after step, as a program
/// that drills with it would. One iteration: CGAL's steps up to the next maintenance, then TDBD's.
/// The reported time is CGAL's.
void corefinement_of_own_result(benchmark::State& state) {
  Drilling d = after_one_revolution("standard-workload", 1.0 * mm);
  mesh::TriangleMesh block_W = block_of(d);
  Side cgal, tdbd;
  const long period = d.plan.maintenance.every;
  for (auto _ : state) {
    const double before = cgal.cpu_seconds;
    for (long i = 0; i < period; ++i) {
      BooleanCut cut = cut_by_corefinement(block_W, swept_corners_W(d, i));
      add(cut, cgal);
      block_W = std::move(cut.block_W);
    }
    state.SetIterationTime(cgal.cpu_seconds - before);
    add_steps(period, d, tdbd);
  }
  report(state, cgal, tdbd);
  state.counters["cgal_triangles"] = static_cast<double>(block_W.triangles.size());
}

/// Median of five repetitions, each the same 200 steps.
void repeat(benchmark::internal::Benchmark* b) {
  b->Unit(benchmark::kMicrosecond)->Iterations(200)->Repetitions(5)->ReportAggregatesOnly();
}

BENCHMARK_CAPTURE(step, bit_b_1_mm, "bit-b-steady", 1.0 * mm)->Apply(repeat);
BENCHMARK_CAPTURE(step, standard_1_mm, "standard-workload", 1.0 * mm)->Apply(repeat);
BENCHMARK_CAPTURE(step, standard_2_mm, "standard-workload", 2.0 * mm)->Apply(repeat);

/// Median of three repetitions, each the same steps.
void race(benchmark::internal::Benchmark* b) {
  b->Unit(benchmark::kMillisecond)->UseManualTime()->Repetitions(3)->ReportAggregatesOnly();
}

BENCHMARK(corefinement_of_our_rock)->Apply(race)->Iterations(15);
BENCHMARK(corefinement_of_own_result)->Apply(race)->Iterations(3);

}  // namespace
}  // namespace tdbd::bench
