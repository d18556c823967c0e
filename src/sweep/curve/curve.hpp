#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulation/case/case.hpp"
#include "sweep/curve/rate_search.hpp"
#include "sweep/sweep.hpp"

namespace tdbd::sweep {

/// A rock of a curve: the overrides that put it into the case.
struct CurveRock {
  std::string name;
  std::vector<std::string> overrides;
};

/// What `tdbd curve` runs.
struct CurvePlan {
  std::string case_file = {};
  std::vector<std::string> overrides = {};
  std::vector<CurveRock> rocks = {};  ///< at least one
  std::vector<double> weights = {};   ///< N, ascending; empty: only those that the search needs
  std::optional<double> rate = {};    ///< m/s: the weight for this rate is looked for
  double tolerance = 0.02;            ///< of the rate, relative
  long most_runs = 8;                 ///< of the search, for each rock, besides `weights`
};

/// A run at one weight in one rock. NaN: failed or not known.
struct CurvePoint {
  double weight_set = 0.0;                                            ///< N
  double wob = 0.0, rop = 0.0, tob = 0.0;                             ///< N, m/s, N m: means
  double rotary_speed = 0.0;                                          ///< rad/s, mean
  double specific_energy = 0.0;                                       ///< Pa, mechanical
  double wob_interval = 0.0, rop_interval = 0.0, tob_interval = 0.0;  ///< half-widths, 95 %
  Steady steady = Steady::unknown;
  std::string message = {};  ///< why the run failed; empty: it did not
};

/// How the search for a rate ended.
enum class RateEnd { none, found, within_interval, out_of_reach, falls, unresolved, failed };

/// The points of one rock, in ascending order of weight, and the result of the search.
struct Curve {
  std::string rock;
  std::vector<CurvePoint> points = {};
  RateEnd end = RateEnd::none;  ///< none: no rate is looked for, or the search was interrupted
  std::size_t nearest = 0;      ///< the point that has the rate, or is nearest to it
  long search_runs = 0;
};

struct CurveResult {
  std::vector<Curve> curves;  ///< one for each rock
  bool interrupted = false;
  bool same_in_all_rocks = false;  ///< the law of faces and chamfers ignores the rock
};

/// Throws InputError unless the weight of a case is set: a bit that drills under a constant
/// weight_on_bit. Returns that weight, N.
double require_weight_driven(const simulation::Case& c);

/// The overrides that put a named rock into a case. Throws InputError with the names of all rocks.
CurveRock rock_by_name(const std::string& name);

/// The rock of a case with another unconfined strength (Pa), with the friction angle of the first
/// rock of the case. `name`: for the curve.
CurveRock rock_by_strength(const simulation::Case& c, const std::string& name, double strength);

/// Runs the weights of a plan in every rock, and then, for a rate, one more weight for each rock at
/// a time until next_weight finds the rate. Points are run and stored like those of a sweep
/// (run_listed): finished ones are found again. The first weight of a search without `weights` is
/// that of the planar model at the rate, or that of the case. Throws InputError and RunError.
CurveResult run_curve(const CurvePlan& plan, const SweepOptions& options);

/// One sentence on the search in one rock: the weight for the rate, or why there is none, with the
/// largest or smallest rate found. Weights are in kN and rates in m/h.
std::string rate_text(const CurvePlan& plan, const Curve& curve);

/// The text of curve.csv: a row for each point, with units in the names of the columns.
std::string curve_csv(const CurveResult& result);

/// The text of rates.csv: a row for each rock with the weight for the rate.
std::string rates_csv(const CurvePlan& plan, const CurveResult& result);

}  // namespace tdbd::sweep
