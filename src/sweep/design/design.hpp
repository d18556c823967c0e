#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/config/config.hpp"

namespace tdbd::sweep {

/// The command that is run at each point.
enum class Command { run, rotate, calibrate, bit, planar };

/// How the intervals of factors are sampled.
enum class Sampling { none, latin_hypercube, sobol };

enum class Scale { linear, log };

/// One value of a factor.
struct Level {
  ConfigWord word;                    ///< the override of the case's key
  std::optional<double> number = {};  ///< empty: a text, such as a choice or a path
  std::string unit = {};              ///< as written; empty: no unit
};

/// The range of a factor's samples.
struct Interval {
  double from = 0.0, to = 0.0;  ///< in `unit`
  std::string unit;
  Scale scale = Scale::linear;
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
};

/// A filter: the planar model evaluates all points, and only the best ones are run.
struct Filter {
  Goal goal;      ///< a value computed by the command planar
  long keep = 1;  ///< number of points
};

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
  double penetration = 0.0;   ///< m per revolution; for the command bit
  double normal_ratio = 0.8;  ///< normal over cutting force; for the planar model
  std::optional<Filter> filter;
};

/// Largest number of points that is allowed.
inline constexpr long most_points = 10'000'000;

/// Reads a design. Throws InputError that lists every mistake: file, line, key, found, expected.
Design read_design(const std::string& file);

/// Returns the design of a filter: its objective by the planar model, at the same points.
Design planar_design(const Design& d);

/// Returns "run", "rotate", "calibrate", "bit" or "planar".
const char* name_of(Command command);

}  // namespace tdbd::sweep
