#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/config/config.hpp"
#include "core/config/key_table.hpp"

namespace tdbd::sweep {

/// The command that is run at each point.
enum class Command { run, rotate, calibrate, bit, planar };

/// How the intervals of factors are sampled.
enum class Sampling { none, latin_hypercube, sobol };

enum class Scale { linear, log };

/// One value of a factor.
struct Level {
  ConfigScalar word;                  ///< the override of the case's key
  std::optional<double> number = {};  ///< empty: a text, such as a choice or a path
  std::string unit = {};              ///< as written; empty: no unit
};

/// The range of a factor's samples.
struct Interval {
  double from = 0.0, to = 0.0;  ///< in `unit`
  std::string unit;
  Scale scale = Scale::linear;
};

/// [[factors]].
struct FactorSettings {
  std::string key;
  std::vector<ConfigScalar> values;
  ConfigScalar from, to;
  long count = 0;  ///< 0: the factor is sampled
  Scale scale = Scale::linear;

  static constexpr TableKey table{"factors", "a key of the case that varies", Repeats::yes};
  void visit(FieldVisitor& v) {
    v(key, {.name = "key", .need = Need::required, .meaning = "dotted, as in --set"});
    const bool listed = v.gives("values");
    if (v.when(listed)) {
      v(values, {.name = "values",
                 .need = Need::required,
                 .computed_default = "required without from and to",
                 .meaning = "the levels, each a value of the key"});
    }
    if (v.when(!listed && (v.gives("from") || v.gives("to")))) {
      v(from, {.name = "from",
               .need = Need::required,
               .computed_default = "required without values",
               .meaning = "the lowest level, or the lower end of samples"});
      v(to, {.name = "to",
             .need = Need::required,
             .computed_default = "required with from",
             .meaning = "the highest, in the unit of from"});
      v(count, {.name = "count",
                .need = Need::optional,
                .computed_default = "none: the factor is sampled",
                .lo = 2,
                .hi = 4'000'000'000,
                .meaning = "of levels, both ends included"});
      v(scale, {.name = "scale",
                .values = {{{"linear", Scale::linear}, {"log", Scale::log}}},
                .meaning = "scale on which levels or samples are evenly spaced"});
    }
  }
};

/// A key of the case that varies: over levels, or within an interval.
struct Factor {
  std::string key;
  std::vector<Level> levels;         ///< empty: sampled
  std::optional<Interval> interval;  ///< of a sampled factor
};

/// The direction in which a summary value improves.
enum class Sense { smaller, larger };

struct Goal {
  std::string figure;
  Sense sense = Sense::smaller;

  static constexpr TableKey table{"goals", "an objective of the non-dominated front", Repeats::yes};
  void visit(FieldVisitor& v) {
    v(figure, {.name = "figure", .need = Need::required, .meaning = "one of sweep.figures"});
    v(sense, {.name = "better",
              .values = {{{"smaller", Sense::smaller}, {"larger", Sense::larger}}},
              .meaning = "which of two values is preferred"});
  }
};

/// Largest number of points that is allowed.
inline constexpr long most_points = 10'000'000;

/// A filter: the planar model evaluates all points, and only the best ones are run. The case
/// without the factors and some of the other points are run too, because the best points alone do
/// not show whether the filter's values follow the results.
struct Filter {
  Goal goal;          ///< a value computed by the command planar
  long keep = 1;      ///< number of points
  long samples = -1;  ///< number of others that are run; -1: sample_count

  static constexpr TableKey table{
      "filter",
      "the planar model evaluates all points; the best, some others and the unchanged case are "
      "run"};
  void visit(FieldVisitor& v) {
    v(goal.figure, {.name = "figure", .need = Need::required, .meaning = "of the command planar"});
    v(goal.sense, {.name = "better",
                   .values = {{{"smaller", Sense::smaller}, {"larger", Sense::larger}}},
                   .meaning = "which of two values is preferred"});
    v(keep, {.name = "keep",
             .need = Need::required,
             .lo = 1,
             .hi = most_points,
             .meaning = "points that are run: those that the planar model finds best"});
    v(samples, {.name = "samples",
                .need = Need::optional,
                .computed_default = "a third of keep, rounded up",
                .lo = 0,
                .hi = most_points,
                .meaning = "other points that are run, evenly over the ranking, to measure how "
                           "well the filter follows the results"});
  }
};

/// Number of points besides the best ones that a filter runs.
inline long sample_count(const Filter& f) {
  constexpr long third = 3;
  return f.samples >= 0 ? f.samples : (f.keep + third - 1) / third;
}

/// Whether a design has a table [filter].
enum class HasFilter { no, yes };

/// A sweep: every combination of levels with every sample.
struct Design {
  std::string file, title;  ///< the path as given; the title of the design
  Command command = Command::run;
  std::string case_file;           ///< absolute
  std::vector<std::string> fixed;  ///< overrides of every point, "key=value"
  std::vector<Factor> factors;     ///< in the order of the file
  Sampling sampling = Sampling::none;
  long samples = 1;
  std::uint64_t seed = 2007;
  std::vector<std::string>
      figures;  ///< numbers of the summary, dotted: "wob_mean_n", "sections.0.mean_area_m2"
  std::vector<Goal> goals;    ///< objectives of the non-dominated front
  double penetration = 5e-3;  ///< m per revolution; for the command bit
  double normal_ratio = 0.8;  ///< normal over cutting force; for the planar model
  std::optional<Filter> filter;

  static constexpr TableKey table{"sweep", "what is done at each point"};
  void visit(FieldVisitor& v, HasFilter has_filter = HasFilter::yes) {
    v.path(case_file, {.name = "case",
                       .need = Need::required,
                       .meaning = "the case (TOML); of the command bit a bit file"});
    v(command, {.name = "command",
                .values = {{{"run", Command::run},
                            {"rotate", Command::rotate},
                            {"calibrate", Command::calibrate},
                            {"bit", Command::bit},
                            {"planar", Command::planar}}},
                .meaning = "that takes the case"});
    v(figures, {.name = "figures",
                .need = Need::required,
                .meaning = "numbers of the command's summary, dotted: \"wob_mean_n\""});
    v(sampling, {.name = "sampling",
                 .values = {{{"none", Sampling::none},
                             {"latin-hypercube", Sampling::latin_hypercube},
                             {"sobol", Sampling::sobol}}},
                 .meaning = "of the factors with from and to but no count"});
    v(samples, {.name = "samples",
                .lo = 1,
                .hi = 4'000'000'000,
                .meaning = "at each combination of levels"});
    v(seed, {.name = "seed", .lo = 0, .hi = 2'147'483'647, .meaning = "of latin-hypercube"});
    if (v.when(command == Command::bit)) {
      v(penetration, {.name = "penetration",
                      .unit = "m",
                      .range = Range::positive(),
                      .meaning = "per revolution, of the command bit",
                      .usual = Range::within(0.0, 0.1)});
    }
    if (v.when(command == Command::planar || has_filter == HasFilter::yes)) {
      v(normal_ratio, {.name = "normal_ratio",
                       .range = Range::positive(),
                       .meaning = "normal over cutting force, of the planar model without "
                                  "the force law of the case"});
    }
  }
};

/// Returns the tables of a design, for `tdbd keys --design`.
std::vector<KeyTable> design_tables();

/// Reads a design. Throws InputError that lists every mistake: file, line, key, found, expected.
Design read_design(const std::string& file);

/// Returns the design of a filter: its objective by the planar model, at the same points.
Design planar_design(const Design& d);

/// Returns "run", "rotate", "calibrate", "bit" or "planar".
const char* name_of(Command command);

/// Returns a word together with its number and unit, if it has them.
Level level_of(const ConfigScalar& word);

/// Returns a number with a unit as a level: "7.5 mm".
Level level_at(double number, const std::string& unit);

/// Returns the interval of a factor with from and to. Records mistakes: ends that are not numbers,
/// have different units, or are not allowed on a logarithmic scale.
Interval interval_of(Config& factor, const FactorSettings& settings);

/// Returns the position at a fraction u of the interval, 0 <= u <= 1. The ends are exact.
double place_in(const Interval& i, double u);

/// Returns evenly spaced levels, including both ends. `count`: at least two.
std::vector<Level> levels_in(const Interval& i, long count);

/// Largest number of dimensions for which GSL has direction numbers.
inline constexpr long most_sobol_dimensions = 40;

/// Whether a factor has an interval instead of levels.
bool is_sampled(const Factor& f);

/// Returns the samples of a design: rows of fractions in [0, 1), with one column per sampled
/// factor. Each column of a Latin hypercube (McKay, Beckman and Conover 1979) has one value in each
/// of `samples` equal parts. Sobol's sequence (1967) begins with its first point, which is the
/// centre.
std::vector<std::vector<double>> samples_of(const Design& d);

/// The points of a design: all combinations of levels and samples. Samples vary fastest, then the
/// levels of the last factor.
struct Points {
  long count = 0;
  std::vector<std::vector<double>> samples;
};
Points points_of(const Design& d);

/// Returns the level of each factor at a point.
std::vector<Level> levels_at(const Design& d, const Points& points, long index);

/// Returns the overrides of a point: the fixed values, then those of the factors.
std::vector<std::string> overrides_at(const Design& d, const Points& points, long index);

}  // namespace tdbd::sweep
