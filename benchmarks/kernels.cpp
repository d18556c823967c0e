// The kernels of a step, each with typical input while bit B drills; sections and contact areas on
// the standard workload.

#include <benchmark/benchmark.h>

#include <vector>

#include "benchmarks/drilling.hpp"
#include "reference/literature/surface/range_search.hpp"
#include "reference/rock/facet_walk.hpp"
#include "rock/cut/group_cut.hpp"
#include "rock/cut/swept_part.hpp"
#include "rock/maintain/maintain.hpp"

namespace tdbd::bench {
namespace {

constexpr double edge_length = 1e-3;  // m

Drilling bit_b() { return after_one_revolution("bit-b-steady", edge_length); }

std::vector<rock::GroupMotion> next_motions(const Drilling& d) {
  std::vector<rock::GroupMotion> motions;
  for (const rock::CuttingGroup& g : d.run.work.cutting.groups)
    motions.push_back(rock::group_motion(g, pose_after(d, 0.0), pose_after(d, 1.0)));
  return motions;
}

rock::RelativePath path_of(const rock::CuttingGroup& g, const rock::GroupMotion& m,
                           const Vec3& x_W) {
  return rock::relative_path(m.X_PW0, m.X_PW1, x_W, rock::mapped_direction_W(g, m, x_W));
}

/// A vertex that the next step sweeps, and its path relative to the part that sweeps it.
struct Query {
  const rock::CuttingPart* part;
  rock::RelativePath path;
};

std::vector<Query> queries_of_next_step(const Drilling& d) {
  std::vector<Query> queries;
  rock::NearGroup near;
  rock::SweptScratch scratch;
  for (const rock::CuttingGroup& g : d.run.work.cutting.groups) {
    const auto motion = rock::group_motion(g, pose_after(d, 0.0), pose_after(d, 1.0));
    rock::NearList list;
    update_near_list(d.run.state.rock.grid, {g.box_P, motion.X_WP0, motion.X_WP1, motion.region_W},
                     {}, list);
    rock::find_candidates(g, motion, d.run.state.rock.surface, list, -1.0, near);
    for (const int place : near.places)
      for (const rock::CuttingPart& part : g.parts) {
        const auto path = path_of(
            g, motion, d.run.state.rock.surface.position(list.v[static_cast<std::size_t>(place)]));
        if (rock::is_swept(part, path, scratch)) queries.push_back({&part, path});
      }
  }
  return queries;
}

/// One item is the exit of one swept vertex from a part given by its planes.
void exit_convex(benchmark::State& state) {
  const Drilling d = bit_b();
  const std::vector<Query> queries = queries_of_next_step(d);
  rock::SweptScratch scratch;
  for (auto _ : state)
    for (const Query& q : queries)
      benchmark::DoNotOptimize(rock::exit_distance(*q.part, q.path, scratch));
  state.SetItemsProcessed(state.iterations() * static_cast<long>(queries.size()));
}

/// The same parts and paths, with every part as a tree over its facets, as if it were not convex.
void exit_mesh(benchmark::State& state) {
  const Drilling d = bit_b();
  const std::vector<Query> queries = queries_of_next_step(d);
  std::vector<mesh::TriangleTree> trees;
  for (const bit::Part& p : d.plan.bit.parts) trees.emplace_back(p.mesh_P);
  rock::MeshScratch scratch;
  for (auto _ : state)
    for (const Query& q : queries)
      benchmark::DoNotOptimize(rock::exit_distance(trees[static_cast<std::size_t>(q.part->part)],
                                                   q.path, q.part->depth, scratch));
  state.SetItemsProcessed(state.iterations() * static_cast<long>(queries.size()));
}

/// The same by walks over neighbouring facets (rock (6)).
void exit_walk(benchmark::State& state) {
  const Drilling d = bit_b();
  const std::vector<Query> queries = queries_of_next_step(d);
  std::vector<mesh::TriangleTree> trees;
  std::vector<reference::FacetNeighbours> across;
  for (const bit::Part& p : d.plan.bit.parts)
    across.push_back(reference::neighbours_of(trees.emplace_back(p.mesh_P)));
  std::vector<reference::WalkScratch> scratch(trees.size());
  for (auto _ : state)
    for (const Query& q : queries) {
      const auto part = static_cast<std::size_t>(q.part->part);
      benchmark::DoNotOptimize(reference::exit_distance_by_walk(trees[part], across[part], q.path,
                                                                q.part->depth, scratch[part]));
    }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(queries.size()));
  double tried = 0.0, found = 0.0, answered = 0.0;
  for (const reference::WalkScratch& s : scratch) {
    tried += static_cast<double>(s.walk.tried);
    found += static_cast<double>(s.walk.found);
    answered += static_cast<double>(s.walk.answered);
  }
  state.counters["found"] = found / tried;
  state.counters["answered"] = answered / tried;
}

/// One iteration visits the vertices near every group of parts. One item is a vertex.
void grid_query(benchmark::State& state) {
  const Drilling d = bit_b();
  const std::vector<rock::GroupMotion> motions = next_motions(d);
  std::vector<int> chains;
  long vertices = 0;
  for (auto _ : state)
    for (const rock::GroupMotion& m : motions)
      d.run.state.rock.grid.visit(m.region_W, chains,
                                  [&](const rock::VertexGrid::Block& b) { vertices += b.count; });
  benchmark::DoNotOptimize(vertices);
  state.SetItemsProcessed(vertices);
}

/// The same with axis-aligned boxes alone, as in the thesis.
void grid_query_box(benchmark::State& state) {
  const Drilling d = bit_b();
  const std::vector<rock::GroupMotion> motions = next_motions(d);
  std::vector<int> chains;
  long vertices = 0;
  for (auto _ : state)
    for (const rock::GroupMotion& m : motions)
      d.run.state.rock.grid.visit({m.region_W.box, {}}, chains,
                                  [&](const rock::VertexGrid::Block& b) { vertices += b.count; });
  benchmark::DoNotOptimize(vertices);
  state.SetItemsProcessed(vertices);
}

std::vector<Vec3> vertices_of(const mesh::Surface& surface) {
  std::vector<Vec3> places;
  for (int v = 0; v < surface.vertex_slots(); ++v)
    if (surface.is_alive(v)) places.push_back(surface.position(v));
  return places;
}

/// The same boxes with a standard k-d tree over the vertices.
void range_search(benchmark::State& state) {
  const Drilling d = bit_b();
  const std::vector<rock::GroupMotion> motions = next_motions(d);
  const reference::RangeSearch search(vertices_of(d.run.state.rock.surface));
  std::vector<int> found;
  long vertices = 0;
  for (auto _ : state)
    for (const rock::GroupMotion& m : motions) {
      search.find({m.region_W.box.lo, m.region_W.box.hi}, found);
      vertices += static_cast<long>(found.size());
    }
  benchmark::DoNotOptimize(vertices);
  state.SetItemsProcessed(vertices);
}

/// The additional work of the tree after vertices have moved: its boxes are recomputed.
void range_search_refit(benchmark::State& state) {
  const Drilling d = bit_b();
  const std::vector<Vec3> places = vertices_of(d.run.state.rock.surface);
  reference::RangeSearch search(places);
  for (auto _ : state) {
    search.refit(places);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(places.size()));
}

/// Tests every vertex in the groups' lists against the hull of its group.
void find_candidates(benchmark::State& state) {
  const Drilling d = bit_b();
  const std::vector<rock::GroupMotion> motions = next_motions(d);
  rock::NearGroup near;
  for (auto _ : state)
    for (std::size_t i = 0; i < motions.size(); ++i) {
      rock::find_candidates(d.run.work.cutting.groups[i], motions[i], d.run.state.rock.surface,
                            d.run.state.rock.near_lists[i], -1.0, near);
      benchmark::DoNotOptimize(near.places.data());
    }
}

/// One maintenance of what five steps have touched. The steps are not timed.
void maintain(benchmark::State& state) {
  Drilling d = bit_b();
  const long period = d.plan.maintenance.every;
  d.plan.maintenance.every = 0;
  long touched = 0;
  for (auto _ : state) {
    drill(d, period);
    touched += static_cast<long>(d.run.state.rock.touched_list.size());
    const double start = cpu_seconds();
    rock::maintain(d.run.state.rock, d.run.work.limits, d.run.work.maintenance_work,
                   d.run.state.maintenance);
    state.SetIterationTime(cpu_seconds() - start);
  }
  state.SetItemsProcessed(touched);
}

/// One iteration measures the sections ahead of all 40 faces of the standard workload.
void sections(benchmark::State& state) {
  Drilling d = after_one_revolution("standard-workload", edge_length);
  const std::vector<rock::SectionFace>& faces = d.run.work.faces.faces;
  const Pose X_WB0 = pose_after(d, -1.0), X_WB1 = pose_after(d, 0.0);
  const rotation::Twist twist = rotation::twist_from(X_WB0, X_WB1, d.plan.time.step);
  const rock::SectionPlace place{d.plan.measure.section_lead * edge_length, edge_length};
  rock::SectionWork work;
  for (auto _ : state)
    for (const rock::SectionFace& face : faces)
      benchmark::DoNotOptimize(rock::section(d.run.state.rock, face, X_WB1, twist, place, work));
  state.SetItemsProcessed(state.iterations() * static_cast<long>(faces.size()));
}

/// One iteration measures the contact areas of all parts of the standard workload after a step.
void contact_areas(benchmark::State& state) {
  Drilling d = after_one_revolution("standard-workload", edge_length);
  const rock::ContactOptions options{d.plan.measure.contact_gap * edge_length, {}};
  rock::ContactWork work;
  std::vector<rock::PartContact> contacts;
  for (auto _ : state) {
    rock::contact_areas(d.run.state.rock, d.run.work.cutting, d.run.work.cut_work, options, work,
                        contacts);
    benchmark::DoNotOptimize(contacts.data());
  }
}

/// Time of both measurements within a run of the standard workload, with realistic cache contents.
void measures_in_a_run(benchmark::State& state) {
  Drilling d = after_one_revolution("standard-workload", edge_length);
  const simulation::MeasurePlan plan = d.plan.measure;
  d.plan.measure.section = simulation::SectionMeasure::off;
  d.plan.measure.contact = simulation::ContactMeasure::off;
  for (auto _ : state) {
    drill(d, 1);
    const simulation::Move move{pose_after(d, -1.0), pose_after(d, 0.0), d.plan.time.step, 0.0, 1};
    simulation::Work& work = d.run.work;
    const simulation::MeasuredStep step{
        d.plan.bit, work.cutting, work.cut_work, d.run.state.cut, move, edge_length, 0, {}};
    const double start = cpu_seconds();
    simulation::measure_cut(d.run.state.rock, plan, work.faces, step, work.measure_work,
                            work.measures);
    state.SetIterationTime(cpu_seconds() - start);
  }
}

/// Median of five repetitions.
void repeat(benchmark::internal::Benchmark* b) {
  b->Unit(benchmark::kMicrosecond)->Repetitions(5)->ReportAggregatesOnly();
}

BENCHMARK(exit_convex)->Apply(repeat);
BENCHMARK(exit_mesh)->Apply(repeat);
BENCHMARK(exit_walk)->Apply(repeat);
BENCHMARK(grid_query)->Apply(repeat);
BENCHMARK(grid_query_box)->Apply(repeat);
BENCHMARK(range_search)->Apply(repeat);
BENCHMARK(range_search_refit)->Apply(repeat);
BENCHMARK(find_candidates)->Apply(repeat);
BENCHMARK(sections)->Apply(repeat);
BENCHMARK(contact_areas)->Apply(repeat);
BENCHMARK(measures_in_a_run)->Apply(repeat)->UseManualTime()->Iterations(200);
BENCHMARK(maintain)->Apply(repeat)->UseManualTime()->Iterations(100);

}  // namespace
}  // namespace tdbd::bench
