#include "sweep/curve/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "core/error.hpp"
#include "forces/rock/rock_material.hpp"
#include "sweep/point/run_point.hpp"

namespace tdbd::sweep {
namespace {

namespace sim = simulation;
using Words = std::vector<std::string>;

constexpr double hour = 3600.0;  // s

/// The figures of a point, in the order of curve_point.
const Words& figure_list() {
  static const Words all{"wob_mean_n",
                         "rop_mean_m_per_s",
                         "tob_mean_n_m",
                         "rotary_speed_mean_rad_per_s",
                         "mechanical_specific_energy_pa",
                         "uncertainty.wob_mean_n",
                         "uncertainty.rop_mean_m_per_s",
                         "uncertainty.tob_mean_n_m"};
  return all;
}

CurvePoint curve_point(double weight, const PointRecord& record) {
  const PointOutcome& o = record.outcome;
  return {.weight_set = weight,
          .wob = o.figures[0],
          .rop = o.figures[1],
          .tob = o.figures[2],
          .rotary_speed = o.figures[3],
          .specific_energy = o.figures[4],
          .wob_interval = o.figures[5],
          .rop_interval = o.figures[6],
          .tob_interval = o.figures[7],
          .steady = o.steady,
          .message = o.message};
}

/// The points that succeeded, and their indices in the curve.
struct Rates {
  std::vector<RatePoint> points;
  std::vector<std::size_t> of_curve;
};

Rates rates_of(const Curve& curve) {
  Rates rates;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const CurvePoint& p = curve.points[i];
    if (!std::isfinite(p.rop)) continue;
    rates.points.push_back(
        {p.weight_set, p.rop, std::isfinite(p.rop_interval) ? p.rop_interval : 0.0});
    rates.of_curve.push_back(i);
  }
  return rates;
}

/// A run that is due.
struct Due {
  std::size_t rock = 0;
  double weight = 0.0;  // N
};

/// The runs and the state of the search in all rocks.
class CurveRuns {
 public:
  CurveRuns(const CurvePlan& plan, const SweepOptions& options)
      : plan_(plan), options_(options), failed_(plan.rocks.size()) {
    design_.file = design_.case_file =
        std::filesystem::absolute(plan.case_file).lexically_normal().string();
    design_.figures = figure_list();
    for (const CurveRock& rock : plan.rocks) result_.curves.push_back({.rock = rock.name});
    for (const CurveRock& rock : plan.rocks)
      cases_.push_back(sim::read_case(plan.case_file, overrides_of(rock)));
    result_.same_in_all_rocks = is_same_in_all_rocks();
    std::set<std::string> doubts;
    for (const sim::Case& c : cases_)
      for (const std::string& doubt : sim::doubts_about_numbers(c.warnings)) doubts.insert(doubt);
    if (options.warn) std::ranges::for_each(doubts, options.warn);
  }

  CurveResult run() {
    std::vector<Due> due;
    for (std::size_t r = 0; r < plan_.rocks.size(); ++r)
      for (const double weight : plan_.weights) due.push_back({r, weight});
    if (due.empty()) due = search();
    while (!due.empty() && !result_.interrupted) {
      run_all(due);
      if (!result_.interrupted) due = search();
    }
    return std::move(result_);
  }

 private:
  Words overrides_of(const CurveRock& rock) const {
    Words all = plan_.overrides;
    all.insert(all.end(), rock.overrides.begin(), rock.overrides.end());
    return all;
  }

  /// The weight of the planar model at a rate; nothing if it does not apply.
  std::optional<double> planar_weight(std::size_t rock, double rate) const {
    sim::Case c = cases_[rock];
    c.motion.rate_of_penetration = rate;
    try {
      const auto weight = planar_summary(c, Design{}.normal_ratio)["wob_n"];
      if (weight.is_number() && weight.get<double>() > 0.0) return weight.get<double>();
    } catch (const InputError&) {  // a bit without cutters
    }
    return std::nullopt;
  }

  bool is_same_in_all_rocks() const {
    constexpr double any_rate = 10.0 / hour;
    if (plan_.rocks.size() < 2) return false;
    const auto first = planar_weight(0, any_rate);
    for (std::size_t r = 1; r < plan_.rocks.size(); ++r)
      if (!first || planar_weight(r, any_rate) != first) return false;
    return true;
  }

  void run_all(const std::vector<Due>& due) {
    std::vector<Words> list;
    for (const Due& d : due) {
      list.push_back(overrides_of(plan_.rocks[d.rock]));
      list.back().push_back(fmt::format("motion.weight_on_bit={}", d.weight));
    }
    const auto records = run_listed(design_, list, options_);
    for (std::size_t i = 0; i < due.size(); ++i) {
      if (!records[i]) {
        result_.interrupted = true;
        continue;
      }
      auto& points = result_.curves[due[i].rock].points;
      const CurvePoint point = curve_point(due[i].weight, *records[i]);
      points.insert(std::ranges::upper_bound(points, point.weight_set, {}, &CurvePoint::weight_set),
                    point);
      if (!point.message.empty() && result_.curves[due[i].rock].search_runs > 0)
        failed_[due[i].rock] = 1;
    }
  }

  /// The next run of every search that has not ended.
  std::vector<Due> search() {
    std::vector<Due> due;
    if (!plan_.rate) return due;
    for (std::size_t r = 0; r < result_.curves.size(); ++r)
      if (const auto weight = next_of(r)) {
        ++result_.curves[r].search_runs;
        due.push_back({r, *weight});
      }
    return due;
  }

  /// The next weight of a rock. Nothing: the search has ended, and the curve states how.
  std::optional<double> next_of(std::size_t rock) {
    Curve& curve = result_.curves[rock];
    if (curve.end != RateEnd::none) return std::nullopt;
    const Rates rates = rates_of(curve);
    RateGoal goal{*plan_.rate, plan_.tolerance, 0.0};
    const bool has_failed = failed_[rock] != 0 || (rates.points.empty() && !curve.points.empty());
    if (has_failed) {
      curve.end = RateEnd::failed;
      return std::nullopt;
    }
    if (rates.points.empty())
      goal.first_weight =
          planar_weight(rock, goal.rate).value_or(require_weight_driven(cases_[rock]));
    const RateProposal p = next_weight(rates.points, goal);
    if (p.step == SearchStep::run && curve.search_runs < plan_.most_runs) return p.weight;
    curve.nearest =
        rates.of_curve[p.step == SearchStep::run ? nearest_rate(rates.points, goal.rate) : p.point];
    curve.end = ended(rates, p.step, curve.points[curve.nearest]);
    return std::nullopt;
  }

  RateEnd ended(const Rates& rates, SearchStep step, const CurvePoint& nearest) const {
    if (step == SearchStep::found) return RateEnd::found;
    if (step == SearchStep::falls) return RateEnd::falls;
    if (std::abs(nearest.rop - *plan_.rate) <= nearest.rop_interval)
      return RateEnd::within_interval;
    return is_within_reach(rates.points, *plan_.rate) ? RateEnd::unresolved : RateEnd::out_of_reach;
  }

  const CurvePlan& plan_;
  const SweepOptions& options_;
  Design design_;
  std::vector<sim::Case> cases_;  // one for each rock
  std::vector<char> failed_;      // by rock: a run of the search failed
  CurveResult result_;
};

}  // namespace

double require_weight_driven(const sim::Case& c) {
  const auto reject = [&c](const std::string& found) {
    throw InputError(fmt::format(
        "{}: found {}, expected kind = \"drilling\" with one weight_on_bit, which the curve "
        "varies; where the rate is set, the weight is a result that tdbd run prints",
        c.places.motion, found));
  };
  if (c.motion.kind != sim::MotionKind::drilling) reject("a prescribed motion");
  const dynamics::TopDrive& top = c.motion.driven.top;
  if (top.axial != dynamics::AxialMode::load) reject("a bit that is lowered at a rate");
  if (top.load.values.size() != 1) reject("a weight_on_bit that changes over time");
  return top.load.values.front();
}

CurveRock rock_by_name(const std::string& name) {
  return {forces::rock_named(name).name, {fmt::format("rock.material=\"{}\"", name)}};
}

CurveRock rock_by_strength(const sim::Case& c, const std::string& name, double strength) {
  const double angle = c.forces.rock.strengths.front().friction_angle;
  return {name,
          {fmt::format("rock.material={{ unconfined_strength = {}, friction_angle = {} }}",
                       strength, angle)}};
}

CurveResult run_curve(const CurvePlan& plan, const SweepOptions& options) {
  return CurveRuns(plan, options).run();
}

namespace {

constexpr double kilo = 1e3;

std::string rate_in_words(double rate) { return fmt::format("{:.4g} m/h", hour * rate); }

std::string weight_in_words(double weight) { return fmt::format("{:.4g} kN", weight / kilo); }

std::string point_in_words(const CurvePoint& p) {
  return fmt::format("{} at {}", rate_in_words(p.rop), weight_in_words(p.weight_set));
}

/// A mark behind the numbers of a run whose means drift.
const char* steady_mark(const CurvePoint& p) {
  return p.steady == Steady::no ? "; its means are not steady: run longer" : "";
}

/// The rate of a point with its interval.
std::string with_interval(const CurvePoint& p) {
  return std::isfinite(p.rop_interval)
             ? fmt::format("{:.4g} +- {:.2g} m/h", hour * p.rop, hour * p.rop_interval)
             : rate_in_words(p.rop);
}

std::string out_of_reach(const Curve& curve) {
  const auto by_rate = [](const CurvePoint& p) {
    return std::isfinite(p.rop) ? p.rop : -std::numeric_limits<double>::infinity();
  };
  const CurvePoint& largest = *std::ranges::max_element(curve.points, {}, by_rate);
  const CurvePoint* smallest = &largest;
  for (const CurvePoint& p : curve.points)
    if (p.rop < smallest->rop) smallest = &p;
  return fmt::format("out of reach; the largest rate found is {}, the smallest {}",
                     point_in_words(largest), point_in_words(*smallest));
}

}  // namespace

std::string rate_text(const CurvePlan& plan, const Curve& curve) {
  const std::string head = fmt::format("{}: {}", curve.rock, rate_in_words(plan.rate.value_or(0)));
  if (curve.end == RateEnd::none) return head + " was not found before the interruption";
  if (curve.end == RateEnd::failed) {
    const auto failed =
        std::ranges::find_if(curve.points, [](const CurvePoint& p) { return !p.message.empty(); });
    return fmt::format("{} was not found: the run at {} failed: {}", head,
                       weight_in_words(failed->weight_set), failed->message);
  }
  const CurvePoint& p = curve.points[curve.nearest];
  switch (curve.end) {
    case RateEnd::found:
      return fmt::format("{} takes {} (found {} after {} runs{})", head,
                         weight_in_words(p.weight_set), with_interval(p), curve.points.size(),
                         steady_mark(p));
    case RateEnd::within_interval:
      return fmt::format("{} takes {} (found {}: within its interval, not within the tolerance{})",
                         head, weight_in_words(p.weight_set), with_interval(p), steady_mark(p));
    case RateEnd::falls:
      return fmt::format(
          "{} was not found: the rate falls from {} to {}; give --weights of the rising part, or "
          "run longer",
          head, point_in_words(p), point_in_words(curve.points[curve.nearest + 1]));
    case RateEnd::unresolved:
      return fmt::format(
          "{} was not found within the tolerance; nearest {}; allow more --runs or "
          "run longer",
          head, point_in_words(p));
    default:
      return fmt::format("{} is {}", head, out_of_reach(curve));
  }
}

namespace {

const char* name_of(RateEnd end) {
  switch (end) {
    case RateEnd::found:
      return "found";
    case RateEnd::within_interval:
      return "within-interval";
    case RateEnd::out_of_reach:
      return "out-of-reach";
    case RateEnd::falls:
      return "falls";
    case RateEnd::unresolved:
      return "unresolved";
    case RateEnd::failed:
      return "failed";
    case RateEnd::none:
      break;
  }
  return "interrupted";
}

std::string number_cell(double x) { return std::isfinite(x) ? fmt::format("{}", x) : "nan"; }

std::string quoted(std::string text) {
  for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2)
    text.insert(at, 1, '"');
  return text.find_first_of(",\"\n") == std::string::npos ? text : '"' + text + '"';
}

std::string row_of(const Curve& curve, const CurvePoint& p) {
  constexpr double rpm = 2.0 * std::numbers::pi / 60.0, MPa = 1e6;
  std::string row = quoted(curve.rock);
  for (const double x : {p.weight_set, p.wob, p.wob_interval, hour * p.rop, hour * p.rop_interval,
                         p.tob, p.tob_interval, p.rotary_speed / rpm, p.specific_energy / MPa})
    row += "," + number_cell(x);
  return row + fmt::format(",{},{},{}\n", sweep::name_of(p.steady),
                           p.message.empty() ? "done" : "failed", quoted(p.message));
}

}  // namespace

std::string curve_csv(const CurveResult& result) {
  std::string text =
      "rock,weight_set_n,wob_mean_n,wob_interval_n,rop_mean_m_per_h,rop_interval_m_per_h,"
      "tob_mean_n_m,tob_interval_n_m,rotary_speed_mean_rpm,mechanical_specific_energy_mpa,steady,"
      "status,message\n";
  for (const Curve& curve : result.curves)
    for (const CurvePoint& p : curve.points) text += row_of(curve, p);
  return text;
}

std::string rates_csv(const CurvePlan& plan, const CurveResult& result) {
  std::string text =
      "rock,rate_m_per_h,result,weight_set_n,rop_mean_m_per_h,rop_interval_m_per_h,"
      "steady,message\n";
  for (const Curve& curve : result.curves) {
    const bool has_point = curve.end == RateEnd::found || curve.end == RateEnd::within_interval;
    text += fmt::format("{},{},{}", quoted(curve.rock), hour * plan.rate.value_or(0.0),
                        name_of(curve.end));
    for (const double x :
         {has_point ? curve.points[curve.nearest].weight_set : std::nan(""),
          has_point ? hour * curve.points[curve.nearest].rop : std::nan(""),
          has_point ? hour * curve.points[curve.nearest].rop_interval : std::nan("")})
      text += "," + number_cell(x);
    const Steady steady = has_point ? curve.points[curve.nearest].steady : Steady::unknown;
    text += fmt::format(",{},{}\n", sweep::name_of(steady), quoted(rate_text(plan, curve)));
  }
  return text;
}

}  // namespace tdbd::sweep
