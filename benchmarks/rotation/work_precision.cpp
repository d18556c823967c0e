#include "benchmarks/rotation/work_precision.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>

namespace tdbd::bench {
namespace {

constexpr double finest_error = 2e-11;         // rad; below it, the next target is far away
constexpr double longest_run = 0.4e6;          // us, of the finest run
constexpr int fewest_steps = 10;               // to the case's end
constexpr double ladder = 1.4142135623730951;  // ratio of consecutive numbers of steps
constexpr double tolerances_a_decade = 10.0;
constexpr double coarsest_tolerance = 1e-1, finest_tolerance = 1e-14;

double cpu_microseconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e6 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_nsec);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

WorkPoint run(const RotationCase& c, const Method& method, double setting, int repetitions) {
  WorkPoint point;
  point.setting = setting;
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i) {
    const auto integration = method.start(c, setting);
    const double begin = cpu_microseconds();
    integration->run_to_end();
    times.push_back(cpu_microseconds() - begin);
    point.steps = integration->steps();
    point.torque_evaluations = integration->torque_evaluations();
    if (i == 0) point.errors = errors_of(c, integration->state());
  }
  point.microseconds = median(times);
  return point;
}

/// A step that is too long for an implicit drift, or at which another program fails, gets infinite
/// errors and does not stop the measurement.
WorkPoint try_run(const RotationCase& c, const Method& method, double setting) {
  try {
    return run(c, method, setting, 1);
  } catch (const std::exception&) {
    WorkPoint failed;
    failed.setting = setting;
    failed.errors.attitude = failed.errors.momentum = failed.errors.energy = INFINITY;
    return failed;
  }
}

bool is_over(const WorkPoint& p) {
  return p.errors.attitude < finest_error || p.microseconds > longest_run;
}

double step_of(const RotationCase& c, long steps) {
  return c.duration / static_cast<double>(steps);
}

std::vector<WorkPoint> curve_over_steps(const RotationCase& c, const Method& method) {
  std::vector<WorkPoint> curve;
  for (double n = fewest_steps; curve.empty() || !is_over(curve.back()); n *= ladder)
    curve.push_back(try_run(c, method, step_of(c, std::lround(n))));
  return curve;
}

std::vector<WorkPoint> curve_over_tolerances(const RotationCase& c, const Method& method) {
  std::vector<WorkPoint> curve;
  const double ratio = std::pow(10.0, -1.0 / tolerances_a_decade);
  for (double t = coarsest_tolerance; t > finest_tolerance; t *= ratio) {
    curve.push_back(try_run(c, method, t));
    if (is_over(curve.back())) break;
  }
  return curve;
}

/// The smallest number of steps that reaches the target, between one that misses it and one that
/// reaches it.
WorkPoint fewest_steps_for(const RotationCase& c, const Method& method, double target,
                           const WorkPoint& misses, WorkPoint reaches) {
  long low = std::lround(c.duration / misses.setting);
  long high = std::lround(c.duration / reaches.setting);
  while (high - low > std::max(1L, low / 200)) {
    const long middle = (low + high) / 2;
    const WorkPoint p = try_run(c, method, step_of(c, middle));
    if (p.errors.attitude <= target) {
      high = middle;
      reaches = p;
    } else {
      low = middle;
    }
  }
  return reaches;
}

std::optional<WorkPoint> reach(const RotationCase& c, const Method& method,
                               const std::vector<WorkPoint>& curve, double target) {
  std::size_t first = curve.size();
  while (first > 0 && curve[first - 1].errors.attitude <= target) --first;
  if (first == curve.size()) return std::nullopt;
  WorkPoint found = curve[first];
  if (method.control == Control::step && first > 0)
    found = fewest_steps_for(c, method, target, curve[first - 1], found);
  const int repetitions = std::clamp(static_cast<int>(1e5 / (found.microseconds + 1.0)), 5, 201);
  return run(c, method, found.setting, repetitions);
}

}  // namespace

WorkPrecision measure_work(const RotationCase& c, const Method& method) {
  WorkPrecision work;
  work.curve = method.control == Control::step ? curve_over_steps(c, method)
                                               : curve_over_tolerances(c, method);
  for (const double target : attitude_targets)
    work.at_target.push_back(reach(c, method, work.curve, target));
  return work;
}

}  // namespace tdbd::bench
