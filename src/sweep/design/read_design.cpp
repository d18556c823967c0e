#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "sweep/design/design.hpp"
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
  FactorSettings s;
  read_fields(c, s);
  Factor f;
  f.key = s.key;
  const bool listed = c.has("values"), ranged = c.has("from") || c.has("to");
  if (listed == ranged)
    c.problem("values", listed ? "from or to as well" : "neither values nor from and to",
              "one of the two");
  if (listed) {
    for (const ConfigWord& word : s.values) f.levels.push_back(level_of(word));
    points *= static_cast<double>(f.levels.size());
  }
  if (listed || !ranged) return f;
  f.interval = interval_of(c, s);
  if (!c.has("count")) return f;
  points *= static_cast<double>(s.count);
  check_count(c, points);
  c.stop_at_problems();
  f.levels = levels_in(*f.interval, s.count);
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
    sweep.problem("sampling", "none, and a factor without count",
                  "latin-hypercube or sobol, or a count");
  if (!sampled && d.sampling != Sampling::none)
    sweep.problem("sampling", "no factor to sample", "a factor with from and to but no count");
  if (!sampled && d.samples > 1) sweep.problem("samples", "no factor to sample", "1");
  if (d.sampling == Sampling::sobol &&
      std::ranges::count_if(d.factors, is_sampled) > most_sobol_dimensions)
    sweep.problem("sampling",
                  fmt::format("{} factors to sample", std::ranges::count_if(d.factors, is_sampled)),
                  fmt::format("at most {} with sobol", most_sobol_dimensions));
}

void read_goals(Config& c, Design& d) {
  for (Config table : c.tables(Goal::table)) {
    read_fields(table, d.goals.emplace_back());
    const std::string& figure = d.goals.back().figure;
    if (std::ranges::count(d.figures, figure) == 0)
      table.problem("figure", figure,
                    fmt::format("one of sweep.figures: {}", fmt::join(d.figures, ", ")));
  }
}

/// The planar model requires a bit with cutters and the command run.
void read_filter(Config& c, Design& d) {
  if (!c.has(Filter::table)) return;
  d.filter = read_table<Filter>(c);
  if (d.command != Command::run)
    c.table(Filter::table)
        .problem("", fmt::format("the command {}", name_of(d.command)),
                 "run: the planar model filters cases that are drilled");
}

void check_figures(Config& sweep, const Design& d) {
  if (d.figures.empty()) sweep.problem("figures", "no figure", "at least one");
  if (std::set<std::string>(d.figures.begin(), d.figures.end()).size() < d.figures.size())
    sweep.problem("figures", "a figure twice", "each once");
}

/// What the design is.
struct TitleOfDesign {
  std::string title;

  static constexpr TableKey table{"", "what the design is"};
  void visit(FieldVisitor& v) {
    v(title, {.name = "title", .meaning = "an attribute of the table"});
  }
};

/// `tdbd keys` lists what a table [set] may have.
struct AnyKeyOfCase {
  static constexpr TableKey table{"set", "keys of the case, the same at all points"};
  void visit(FieldVisitor& v) {
    v.any({.name = "KEY",
           .kind = "as in the case",
           .usual = "the case's",
           .meaning = "any key of the case, dotted: time.revolutions; of its bit file behind "
                      "bit.set: bit.set.adjust.back_rake"});
  }
};

}  // namespace

Design read_design(const std::string& file) {
  Config c = Config::read_file(file, {});
  Design d;
  d.file = file;
  TitleOfDesign title;
  read_fields(c, title);
  d.title = title.title;
  Config sweep = c.table(Design::table);
  read_fields(sweep, d, c.has(Filter::table) ? HasFilter::yes : HasFilter::no);
  check_figures(sweep, d);
  d.fixed = c.table(AnyKeyOfCase::table).assignments();
  double points = static_cast<double>(d.samples);
  check_count(c, points);
  for (const Config& factor : c.tables(FactorSettings::table))
    d.factors.push_back(read_factor(factor, points));
  if (d.factors.empty())
    c.problem("factors", "no factor, and so no points", "at least one table [[factors]]");
  read_goals(c, d);
  read_filter(c, d);
  check_keys(c, d);
  check_sampling(sweep, d);
  check_count(c, points);
  c.finish();
  return d;
}

std::vector<KeyTable> design_tables() {
  return tables_of<TitleOfDesign, Design, AnyKeyOfCase, FactorSettings, Goal, Filter>("sweep");
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
