#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/config/config.hpp"

namespace tdbd::sweep {

/// What is done at each point.
enum class Command { run, rotate, calibrate, bit, planar };

/// How the intervals of factors are filled.
enum class Sampling { none, latin_hypercube, sobol };

enum class Scale { linear, log };

/// One value of a factor.
struct Level {
  ConfigWord word;                    ///< as it overrides the case's key
  std::optional<double> number = {};  ///< nothing: a text, as in a choice or a path
  std::string unit = {};              ///< as written; empty: none
};

/// Where samples of a factor lie.
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

/// What a figure should become.
enum class Sense { smaller, larger };

struct Goal {
  std::string figure;
  Sense sense = Sense::smaller;
};

/// Points are first judged by the planar model, and only the best are run.
struct Filter {
  Goal goal;      ///< a figure of the command planar
  long keep = 1;  ///< points
};

/// A sweep: every combination of the levels, at each of them every sample.
struct Design {
  std::string file, title;  ///< as given; what the design is about
  Command command = Command::run;
  std::string case_file;           ///< absolute
  std::vector<std::string> fixed;  ///< overrides of every point, "key=value"
  std::vector<Factor> factors;     ///< in the order of the file
  Sampling sampling = Sampling::none;
  long samples = 1;
  std::uint64_t seed = 2007;
  std::vector<std::string>
      figures;  ///< numbers of the summary, dotted: "wob_mean_n", "sections.0.mean_area_m2"
  std::vector<Goal> goals;    ///< figures of the non-dominated front
  double penetration = 0.0;   ///< m per revolution; of the command bit
  double normal_ratio = 0.8;  ///< normal over cutting force; of the planar model
  std::optional<Filter> filter;
};

/// More points than this are refused.
inline constexpr long most_points = 10'000'000;

/// Reads a design. Throws InputError that lists every mistake: file, line, key, found, expected.
Design read_design(const std::string& file);

/// The design of a filter: its figure by the planar model, at the same points.
Design planar_design(const Design& d);

/// "run", "rotate", "calibrate", "bit", "planar".
const char* name_of(Command command);

}  // namespace tdbd::sweep
