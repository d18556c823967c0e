#include "sweep/design/design.hpp"

#include <fmt/format.h>
#include <gsl/gsl_qrng.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <numeric>
#include <set>

#include "core/random.hpp"
#include "core/text.hpp"

namespace tdbd::sweep {
namespace {

/// Fills one column: a permutation of the parts, with a random position in each part.
void fill_column(std::vector<std::vector<double>>& rows, std::size_t column, Random& random) {
  const std::size_t n = rows.size();
  std::vector<std::size_t> part(n);
  std::iota(part.begin(), part.end(), std::size_t{0});
  for (std::size_t i = n; i > 1; --i) std::swap(part[i - 1], part[random.next() % i]);
  for (std::size_t i = 0; i < n; ++i)
    rows[i][column] = (static_cast<double>(part[i]) + random.uniform()) / static_cast<double>(n);
}

void fill_sobol(std::vector<std::vector<double>>& rows, std::size_t dimensions) {
  const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> sequence{
      gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(dimensions)), &gsl_qrng_free};
  for (std::vector<double>& row : rows) gsl_qrng_get(sequence.get(), row.data());
}

}  // namespace

Level level_of(const ConfigScalar& word) {
  const std::string_view body = trimmed(word.text);
  double number = 0.0;
  const auto [rest, error] = std::from_chars(body.data(), body.data() + body.size(), number);
  if (error != std::errc() || !std::isfinite(number)) return {word};
  const auto used = static_cast<std::size_t>(rest - body.data());
  return {word, number, std::string(trimmed(body.substr(used)))};
}

Level level_at(double number, const std::string& unit) {
  if (!unit.empty()) {
    const std::string text = fmt::format("{} {}", number, unit);
    return {{text, fmt::format("\"{}\"", text)}, number, unit};
  }
  const std::string text = fmt::format("{}", number);
  return {{text, text}, number, unit};
}

Interval interval_of(Config& factor, const FactorSettings& s) {
  const Level from = level_of(s.from), to = level_of(s.to);
  Interval i{from.number.value_or(0.0), to.number.value_or(1.0), from.unit, s.scale};
  if (factor.problem_count() > 0) return i;
  const auto expect = [&](bool right, std::string_view key, const std::string& found,
                          const char* expected) {
    if (!right) factor.problem(key, found, expected);
  };
  expect(from.number.has_value(), "from", from.word.text, "a number, with a unit or without");
  expect(to.number.has_value(), "to", to.word.text, "a number, with a unit or without");
  if (factor.problem_count() > 0) return i;
  expect(from.unit == to.unit, "to", to.word.text, "the unit of from");
  expect(from.unit != to.unit || i.from < i.to, "to", to.word.text, "more than from");
  expect(i.scale == Scale::linear || i.from > 0.0, "from", from.word.text,
         "more than 0 on a logarithmic scale");
  return i;
}

double place_in(const Interval& i, double u) {
  if (u >= 1.0) return i.to;  // exact, like the other end
  return i.scale == Scale::log ? i.from * std::pow(i.to / i.from, u) : i.from + (i.to - i.from) * u;
}

std::vector<Level> levels_in(const Interval& i, long count) {
  std::vector<Level> levels;
  for (long k = 0; k < count; ++k)
    levels.push_back(
        level_at(place_in(i, static_cast<double>(k) / static_cast<double>(count - 1)), i.unit));
  return levels;
}

bool is_sampled(const Factor& f) { return f.interval && f.levels.empty(); }

std::vector<std::vector<double>> samples_of(const Design& d) {
  const auto dimensions = static_cast<std::size_t>(std::ranges::count_if(d.factors, is_sampled));
  if (dimensions == 0) return {};
  std::vector<std::vector<double>> rows(static_cast<std::size_t>(d.samples),
                                        std::vector<double>(dimensions));
  if (d.sampling == Sampling::sobol) {
    fill_sobol(rows, dimensions);
    return rows;
  }
  Random random{d.seed};
  for (std::size_t column = 0; column < dimensions; ++column) fill_column(rows, column, random);
  return rows;
}

Points points_of(const Design& d) {
  Points points{1, samples_of(d)};
  for (const Factor& f : d.factors)
    if (!is_sampled(f)) points.count *= static_cast<long>(f.levels.size());
  if (!points.samples.empty()) points.count *= d.samples;
  return points;
}

std::vector<Level> levels_at(const Design& d, const Points& points, long index) {
  std::vector<Level> levels(d.factors.size());
  const std::vector<double>* row = nullptr;
  if (!points.samples.empty()) {
    row = &points.samples[static_cast<std::size_t>(index % d.samples)];
    index /= d.samples;
  }
  std::size_t column = row == nullptr ? 0 : row->size();
  for (std::size_t i = d.factors.size(); i-- > 0;) {
    const Factor& f = d.factors[i];
    if (is_sampled(f)) {
      levels[i] = level_at(place_in(*f.interval, (*row)[--column]), f.interval->unit);
    } else {
      const auto count = static_cast<long>(f.levels.size());
      levels[i] = f.levels[static_cast<std::size_t>(index % count)];
      index /= count;
    }
  }
  return levels;
}

std::vector<std::string> overrides_at(const Design& d, const Points& points, long index) {
  std::vector<std::string> overrides = d.fixed;
  const std::vector<Level> levels = levels_at(d, points, index);
  for (std::size_t i = 0; i < levels.size(); ++i)
    overrides.push_back(d.factors[i].key + "=" + levels[i].word.toml);
  return overrides;
}

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
    for (const ConfigScalar& word : s.values) f.levels.push_back(level_of(word));
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
           .computed_default = "the case's",
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
