#include "benchmarks/contenders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "benchmarks/workloads.hpp"
#include "core/error.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bench {
namespace {

constexpr const char* spokes = "spokes";

StepKind step_of(Drilling& d) {
  drill(d, 1);
  const long every = d.plan.maintenance.every;
  return every > 0 && d.run.state.steps_done % every == 0 ? StepKind::maintained : StepKind::plain;
}

MeshFigures summarize(const Drilling& d) {
  const mesh::Surface& surface = d.run.state.rock.surface;
  const mesh::QualityStatistics quality = mesh::quality_statistics(surface);
  return {surface.triangle_count(), quality.least, quality.one_percent,
          d.run.state.maintenance.touched_triangles};
}

Contender contender(const Workload& w, const std::vector<std::string>& settings) {
  const auto d = std::make_shared<Drilling>(start_workload(w, settings));
  return {w.name, w.what, [d] { return step_of(*d); }, [d] { return summarize(*d); }};
}

template <class Rock>
Contender contender(std::string name, std::string what, RivalDrilling<Rock> start) {
  const auto rival = std::make_shared<RivalDrilling<Rock>>(std::move(start));
  const auto step = [rival] {
    drill(*rival, 1);
    return StepKind::plain;
  };
  return {std::move(name), std::move(what), step, {}};
}

void require_known(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const Workload& w : workloads()) known.push_back(w.name);
  for (const ZMapWorkload& w : z_map_workloads()) known.push_back(w.name);
  known.push_back(spokes);
  std::string expected;
  for (const std::string& name : known) expected += " " + name;
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InputError(fmt::format("--only: found {}, expected one of{}", name, expected));
}

}  // namespace

std::vector<Contender> contenders(const std::vector<std::string>& names,
                                  const std::vector<std::string>& settings) {
  require_known(names);
  const auto is_wanted = [&](const std::string& name) {
    return names.empty() || name == yardstick ||
           std::find(names.begin(), names.end(), name) != names.end();
  };
  std::vector<Contender> all;
  for (const Workload& w : workloads())
    if (is_wanted(w.name)) all.push_back(contender(w, settings));
  for (const ZMapWorkload& w : z_map_workloads())
    if (is_wanted(w.name)) all.push_back(contender(w.name, w.what, start_workload(w)));
  if (is_wanted(spokes))
    all.push_back(contender(spokes, "120 spokes of 500 nodes", start_spokes_workload()));
  return all;
}

}  // namespace tdbd::bench
