#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "mesh/files/files.hpp"
#include "mesh/measures.hpp"
#include "reference/mesh/self_intersections.hpp"
#include "rock/maintain/collapse.hpp"
#include "rock/maintain/invariants.hpp"
#include "simulation/step/simulation.hpp"

namespace {

using tdbd::Vec3;
using tdbd::mesh::Surface;
using tdbd::simulation::Case;
using tdbd::simulation::Simulation;

constexpr const char* usage =
    "Usage: long-run CASE.toml [--set KEY=VALUE]... [--rows N] [--save SURFACE.ply]\n"
    "Drills a case and writes no result folder: a row of figures at equal intervals, the promises\n"
    "M1 to M7 of the maintenance that ends each (src/rock/README.md), and pairs of triangles that\n"
    "intersect, by CGAL's exact predicates. CPU times are of a step without maintenance and of\n"
    "maintenance by touched triangle. Below the table: why repairs were refused, and what is left\n"
    "of the worst triangles.\n"
    "Example: long-run cases/bit-b-steady.toml --set rock.edge_length=\"'3 mm'\" --rows 4\n"
    "Exit codes: 0 all promises kept, 1 one is broken, 2 the case cannot be run.\n";

struct Options {
  std::string path, save;
  std::vector<std::string> overrides;
  long rows = 10;
};

void print_head() {
  fmt::print("{:>9} {:>9} {:>9} {:>5} {:>6} {:>6} {:>9} {:>9} {:>8} {:>6}  broken\n", "steps",
             "depth mm", "triangles", "pairs", "worst", "1 %", "disturbed", "change", "us/step",
             "ns/tri");
}

struct Times {
  double cutting = 0.0, maintaining = 0.0;  ///< s
  long maintenances = 0, triangles = 0;
  long steps = 0, moves = 0;  ///< vertices moved by the bit
};

/// CPU time of this process, s: other programs on the machine do not count.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Runs steps up to `end` and checks the guarantees of the maintenance after them.
std::string drill(const Case& c, Simulation& s, long end, Times& times) {
  const long touched_before = s.state.maintenance.touched_triangles;
  while (s.state.steps_done < end - 1) {
    const double before = cpu_seconds();
    step(c, s);
    const double took = cpu_seconds() - before;
    const bool maintained = s.state.steps_done % c.maintenance.every == 0;
    (maintained ? times.maintaining : times.cutting) += took;
    times.maintenances += maintained ? 1 : 0;
    ++times.steps;
    times.moves += s.state.cut.moved;
  }
  times.triangles = s.state.maintenance.touched_triangles - touched_before;
  Case without = c;
  without.maintenance.every = 0;
  step(without, s);
  const tdbd::rock::Rock before = s.state.rock;
  tdbd::rock::MaintenanceReport alone;
  tdbd::rock::maintain(s.state.rock, s.work.limits, s.work.maintenance_work, alone);
  const auto found = tdbd::rock::check_maintenance(before, s.state.rock, s.work.limits, alone,
                                                   s.work.maintenance_work.drift);
  tdbd::rock::add(alone, s.state.maintenance);
  return tdbd::rock::describe(found, 3);
}

bool print_row(const Simulation& s, double depth, const Times& t, long cut_steps,
               const std::string& broken) {
  const tdbd::mesh::QualityStatistics q = tdbd::mesh::quality_statistics(s.state.rock.surface);
  const auto pairs =
      tdbd::reference::self_intersecting_pairs(tdbd::mesh::compact(s.state.rock.surface));
  const double removed = s.state.ledger.removed.value();
  const double a_step = t.cutting / static_cast<double>(std::max(1L, cut_steps));
  const double maintaining = t.maintaining - a_step * static_cast<double>(t.maintenances);
  const double a_triangle = maintaining / static_cast<double>(std::max(1L, t.triangles));
  fmt::print("{:9} {:9.2f} {:9} {:5} {:6.3f} {:6.3f} {:9.2e} {:9.1e} {:8.0f} {:6.0f}  {}\n",
             s.state.steps_done, 1e3 * depth, s.state.rock.surface.triangle_count(), pairs, q.least,
             q.one_percent, s.state.maintenance.volume_disturbed / removed,
             s.state.maintenance.volume_change / removed, 1e6 * a_step, 1e9 * a_triangle,
             broken.empty() ? "none" : broken);
  std::fflush(stdout);
  return pairs == 0 && broken.empty();
}

void print_counts(const Simulation& s) {
  for (const auto& [name, count] : tdbd::rock::counts(s.state.maintenance))
    if (count > 0) fmt::print("{} {}\n", name, count);
  fmt::print("volumes balance to {:.1e}\n", tdbd::simulation::ledger_defect(s));
}

/// The worst triangles that are left, and what the guards say of their shortest edge's collapse.
void print_worst(const Simulation& s) {
  const Surface& m = s.state.rock.surface;
  std::vector<std::pair<double, int>> bad;
  for (int t = 0; t < m.triangle_slots(); ++t) {
    const auto& [a, b, c] = m.triangles[static_cast<std::size_t>(t)];
    if (a < 0) continue;
    const double q = tdbd::mesh::triangle_quality(m.position(a), m.position(b), m.position(c));
    if (q < s.work.limits.worst_quality) bad.emplace_back(q, t);
  }
  std::sort(bad.begin(), bad.end());
  fmt::print("{} triangles below quality {}\n", bad.size(), s.work.limits.worst_quality);
  for (std::size_t i = 0; i < std::min<std::size_t>(bad.size(), 8); ++i) {
    const auto& v = m.triangles[static_cast<std::size_t>(bad[i].second)];
    fmt::print("  {:.4f}", bad[i].first);
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = v[k], b = v[(k + 1) % 3];
      const auto verdict = tdbd::rock::judge_collapse(m, a, b, s.work.limits);
      fmt::print("  {:.3f} mm {}", 1e3 * (m.position(a) - m.position(b)).norm(),
                 verdict.refused
                     ? tdbd::rock::refusal_names[static_cast<std::size_t>(*verdict.refused)]
                     : "-");
    }
    const Vec3& x = m.position(v[0]);
    fmt::print("  r = {:.2f} mm, z = {:.2f} mm\n", 1e3 * x.head<2>().norm(), 1e3 * x.z());
  }
}

void print_pairs(const Simulation& s) {
  const auto m = tdbd::mesh::compact(s.state.rock.surface);
  const auto pairs = tdbd::reference::self_intersections(m);
  for (std::size_t i = 0; i < std::min<std::size_t>(pairs.size(), 8); ++i) {
    const auto& v = m.triangles[static_cast<std::size_t>(pairs[i].first)];
    const auto& w = m.triangles[static_cast<std::size_t>(pairs[i].second)];
    const Vec3& x = m.positions[static_cast<std::size_t>(v[0])];
    fmt::print(
        "triangles ({}, {}, {}) and ({}, {}, {}) intersect near r = {:.2f} mm, z = {:.2f} mm\n",
        v[0], v[1], v[2], w[0], w[1], w[2], 1e3 * x.head<2>().norm(), 1e3 * x.z());
  }
}

int run(const Options& o) {
  const Case c = tdbd::simulation::read_case(o.path, o.overrides);
  Simulation s = tdbd::simulation::start(c);
  fmt::print("{}: {} steps, {} triangles at the start\n", o.path, c.time.steps,
             s.state.start_triangles);
  print_head();
  bool kept = true;
  Times last;
  for (long k = 1; k <= o.rows; ++k) {
    Times times;
    const long from = s.state.steps_done, end = c.time.steps * k / o.rows;
    if (end <= from) continue;
    const std::string broken = drill(c, s, end, times);
    const double depth =
        tdbd::simulation::pose_at(c.motion, c.time.step * static_cast<double>(end)).p.z();
    kept = print_row(s, depth, times, end - from - 1 - times.maintenances, broken) && kept;
    last = times;
  }
  fmt::print("vertices moved by a step of the last row {:.1f}\n",
             static_cast<double>(last.moves) / static_cast<double>(std::max(1L, last.steps)));
  print_counts(s);
  print_worst(s);
  print_pairs(s);
  if (!o.save.empty()) tdbd::mesh::write_mesh(o.save, tdbd::mesh::compact(s.state.rock.surface));
  return kept ? 0 : 1;
}

long rows_of(const std::string& text) {
  long rows = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), rows);
  if (error != std::errc{} || end != text.data() + text.size() || rows < 1)
    throw tdbd::InputError("--rows: found \"" + text + "\", expected a number from 1 on");
  return rows;
}

Options options(const std::vector<std::string>& arguments) {
  Options o;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& a = arguments[i];
    const bool wants_value = a == "--set" || a == "--rows" || a == "--save";
    if (wants_value && i + 1 == arguments.size())
      throw tdbd::InputError(a + ": found nothing, expected a value");
    if (a == "--set")
      o.overrides.push_back(arguments[++i]);
    else if (a == "--rows")
      o.rows = rows_of(arguments[++i]);
    else if (a == "--save")
      o.save = arguments[++i];
    else if (o.path.empty() && a.front() != '-')
      o.path = a;
    else
      throw tdbd::InputError("found \"" + a + "\"\n" + usage);
  }
  if (o.path.empty()) throw tdbd::InputError(std::string("no case is named\n") + usage);
  return o;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (std::ranges::find(arguments, "--help") != arguments.end()) {
    std::fputs(usage, stdout);
    return 0;
  }
  try {
    return run(options(arguments));
  } catch (const std::exception& e) {
    std::fprintf(stderr, "long-run: %s\n", e.what());
  }
  return 2;
}
