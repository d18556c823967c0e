#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "sweep/design/design.hpp"
#include "sweep/design/design_keys.hpp"
#include "sweep/design/levels.hpp"
#include "sweep/design/points.hpp"

namespace tdbd::sweep {
namespace {

/// Rejects too many points before they are generated. `points`: the product of all counts.
void check_count(Config& c, double points) {
  if (c.problem_count() > 0 || points <= static_cast<double>(most_points)) return;
  c.problem("", fmt::format("{:.10g} points", points),
            fmt::format("at most {} in one design", most_points));
}

Factor read_factor(Config c, double& points) {
  Factor f;
  f.key = c.read(factor_keys::key);
  const bool listed = c.has(factor_keys::values);
  const bool ranged = c.has(factor_keys::from) || c.has(factor_keys::to);
  if (listed == ranged) {
    c.problem(factor_keys::values, listed ? "from or to as well" : "neither values nor from and to",
              "one of the two");
    if (!listed) return f;
  }
  if (listed) {
    for (const ConfigWord& word : c.words(factor_keys::values)) f.levels.push_back(level_of(word));
    points *= static_cast<double>(f.levels.size());
    return f;
  }
  f.interval = read_interval(c);
  if (!c.has(factor_keys::count)) return f;
  const long count = c.read(factor_keys::count);
  points *= static_cast<double>(count);
  check_count(c, points);
  c.stop_at_problems();
  f.levels = levels_in(*f.interval, count);
  return f;
}

/// Records a mistake unless every factor has a key of its own that is set nowhere else.
void check_keys(Config& c, const Design& d) {
  std::set<std::string> seen;
  for (const std::string& fixed : d.fixed) seen.insert(fixed.substr(0, fixed.find('=')));
  for (std::size_t i = 0; i < d.factors.size(); ++i)
    if (!seen.insert(d.factors[i].key).second)
      c.problem(fmt::format("factors[{}].key", i), fmt::format("{} again", d.factors[i].key),
                "a key that no other factor has, nor [set]");
}

void check_sampling(Config& sweep, const Design& d) {
  const bool sampled = std::ranges::any_of(d.factors, is_sampled);
  if (sampled && d.sampling == Sampling::none)
    sweep.problem(sweep_keys::sampling, "none, and a factor without count",
                  "latin-hypercube or sobol, or a count");
  if (!sampled && d.sampling != Sampling::none)
    sweep.problem(sweep_keys::sampling, "no factor to sample",
                  "a factor with from and to but no count");
  if (!sampled && d.samples > 1) sweep.problem(sweep_keys::samples, "no factor to sample", "1");
  if (d.sampling == Sampling::sobol &&
      std::ranges::count_if(d.factors, is_sampled) > most_sobol_dimensions)
    sweep.problem(sweep_keys::sampling,
                  fmt::format("{} factors to sample", std::ranges::count_if(d.factors, is_sampled)),
                  fmt::format("at most {} with sobol", most_sobol_dimensions));
}

void read_goals(Config& c, Design& d) {
  for (Config goal : c.tables(goal_keys::table)) {
    d.goals.push_back({goal.read(goal_keys::figure), goal.read(goal_keys::better)});
    if (std::ranges::count(d.figures, d.goals.back().figure) == 0)
      goal.problem(goal_keys::figure, d.goals.back().figure,
                   fmt::format("one of sweep.figures: {}", fmt::join(d.figures, ", ")));
  }
}

/// The planar model requires a bit with cutters and the command run.
void read_filter(Config& c, Config& sweep, Design& d) {
  if (d.command == Command::planar || c.has(filter_keys::table))
    d.normal_ratio = sweep.read(sweep_keys::normal_ratio);
  if (!c.has(filter_keys::table)) return;
  Config filter = c.table(filter_keys::table);
  d.filter = Filter{{filter.read(filter_keys::figure), filter.read(goal_keys::better)},
                    filter.read(filter_keys::keep)};
  if (d.command != Command::run)
    filter.problem("", fmt::format("the command {}", name_of(d.command)),
                   "run: the planar model filters cases that are drilled");
}

void read_what(Config& sweep, Design& d) {
  d.case_file = sweep.read(sweep_keys::case_file);
  d.command = sweep.read(sweep_keys::command);
  d.figures = sweep.read(sweep_keys::figures);
  if (d.figures.empty()) sweep.problem(sweep_keys::figures, "no figure", "at least one");
  if (std::set<std::string>(d.figures.begin(), d.figures.end()).size() < d.figures.size())
    sweep.problem(sweep_keys::figures, "a figure twice", "each once");
  d.sampling = sweep.read(sweep_keys::sampling);
  d.samples = sweep.read(sweep_keys::samples);
  d.seed = static_cast<std::uint64_t>(sweep.read(sweep_keys::seed));
  if (d.command == Command::bit) d.penetration = sweep.read(sweep_keys::penetration);
}

}  // namespace

Design read_design(const std::string& file) {
  Config c = Config::read_file(file, {});
  Design d;
  d.file = file;
  d.title = c.read(top_keys::title);
  Config sweep = c.table(sweep_keys::table);
  read_what(sweep, d);
  d.fixed = c.table(set_keys::table).assignments();
  double points = static_cast<double>(d.samples);
  check_count(c, points);
  for (const Config& factor : c.tables(factor_keys::table))
    d.factors.push_back(read_factor(factor, points));
  if (d.factors.empty())
    c.problem("factors", "no factor, and so no points", "at least one table [[factors]]");
  read_goals(c, d);
  read_filter(c, sweep, d);
  check_keys(c, d);
  check_sampling(sweep, d);
  check_count(c, points);
  c.finish();
  return d;
}

const char* name_of(Command command) {
  switch (command) {
    case Command::run:
      return "run";
    case Command::rotate:
      return "rotate";
    case Command::calibrate:
      return "calibrate";
    case Command::planar:
      return "planar";
    case Command::bit:
      break;
  }
  return "bit";
}

Design planar_design(const Design& d) {
  Design planar = d;
  planar.command = Command::planar;
  planar.figures = {d.filter->goal.figure};
  planar.goals.clear();
  planar.filter.reset();
  return planar;
}

}  // namespace tdbd::sweep
