#include "simulation/study/levels.hpp"

#include <algorithm>
#include <iterator>

#include "core/parallel.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "mesh/surface.hpp"
#include "simulation/case/case.hpp"
#include "simulation/result/run.hpp"
#include "simulation/rotate/rotate_case.hpp"
#include "simulation/rotate/rotate_record.hpp"
#include "simulation/rotate/rotate_run.hpp"

namespace tdbd::simulation {
namespace {

double median_edge(const mesh::TriangleMesh& m) {
  if (m.triangles.empty()) return 0.0;
  std::vector<double> lengths;
  for (const mesh::Triangle& t : m.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      lengths.push_back((m.positions[at(t[i])] - m.positions[at(t[(i + 1) % 3])]).norm());
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

double radius(const mesh::TriangleMesh& m) {
  mesh::Box box;
  for (const mesh::Triangle& t : m.triangles)
    for (const int v : t) box.add(m.positions[at(v)]);
  return m.triangles.empty() ? 0.0 : 0.5 * std::max(box.size().x(), box.size().y());
}

}  // namespace

Hole hole_of(const rock::Rock& rock) {
  std::vector<int> slots;
  Hole hole{mesh::compact(rock.surface, &slots), {}};
  hole.cut.positions = hole.rock.positions;
  const auto is_moved = [&](int v) { return rock.last_part[at(slots[at(v)])] >= 0; };
  std::ranges::copy_if(hole.rock.triangles, std::back_inserter(hole.cut.triangles),
                       [&](const mesh::Triangle& t) { return std::ranges::any_of(t, is_moved); });
  hole.edge = median_edge(hole.cut);
  return hole;
}

HoleDifference difference(const Hole& a, const Hole& b) {
  if (a.cut.triangles.empty() && b.cut.triangles.empty()) return {};
  const double edge =
      a.edge > 0.0 && b.edge > 0.0 ? std::min(a.edge, b.edge) : std::max(a.edge, b.edge);
  const mesh::SurfaceDistance there = distance_to(a.cut, mesh::TriangleTree(b.rock), 0.5 * edge),
                              back = distance_to(b.cut, mesh::TriangleTree(a.rock), 0.5 * edge);
  return {std::max(there.largest, back.largest), 0.5 * (there.volume + back.volume),
          std::max(radius(a.cut), radius(b.cut))};
}

namespace {

constexpr const char* this_level = "the level's summary";

LevelOutcome rotate_level(const std::string& file, const std::vector<std::string>& overrides,
                          int number, const ConvergenceOptions& o) {
  const RotateCase c = read_rotate_case(file, overrides);
  RotateOptions options;
  options.interrupted = o.interrupted;
  if (o.progress)
    options.progress = [&](long done, long total) { o.progress(number, done, total); };
  RotateSimulation s = start(c);
  RotateSteps steps(c, s);
  const RunStatus status = run_loop(steps, options);
  return {status,       c.time.step,
          s.steps_done, read_end_state(summary_json(c, s, status), this_level),
          {},           s.rotating.evaluations};
}

LevelOutcome drill_level(const std::string& file, const std::vector<std::string>& overrides,
                         int number, const ConvergenceOptions& o) {
  const Case c = read_case(file, overrides);
  const ThreadLimit limit(o.threads);
  RunOptions options;
  options.interrupted = o.interrupted;
  if (o.progress)
    options.progress = [&](const Simulation& so_far, long total) {
      o.progress(number, so_far.state.steps_done, total);
    };
  Simulation s = start(c);
  DrillingSteps steps(c, s);
  const RunStatus status = run_loop(steps, options);
  LevelOutcome level{status,
                     c.time.step,
                     s.state.steps_done,
                     read_end_state(to_json(summary_of(c, s, status)), this_level),
                     hole_of(s.state.rock),
                     0};
  if (s.state.drive) add_motion(s.state.drive->state, level.end);
  return level;
}

}  // namespace

LevelOutcome run_level(const std::string& case_file, const std::vector<std::string>& overrides,
                       int number, const ConvergenceOptions& o) {
  return is_rotate_case(case_file) ? rotate_level(case_file, overrides, number, o)
                                   : drill_level(case_file, overrides, number, o);
}

}  // namespace tdbd::simulation
