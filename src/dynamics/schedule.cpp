#include "dynamics/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace tdbd::dynamics {
namespace {

/// Number of times at or before t.
std::size_t passed(const Schedule& s, double t) {
  return static_cast<std::size_t>(std::upper_bound(s.times.begin(), s.times.end(), t) -
                                  s.times.begin());
}

/// Integral from the first time to t.
double integral_from_first(const Schedule& s, double t) {
  const std::size_t after = passed(s, t);
  if (after == 0) return s.values.front() * (t - s.times.front());
  const std::size_t i = after - 1;
  const bool ramps = s.interpolation == Interpolation::linear && after < s.times.size();
  const double mean = ramps ? 0.5 * (s.values[i] + value_at(s, t)) : s.values[i];
  return s.integrals[i] + mean * (t - s.times[i]);
}

}  // namespace

std::string schedule_problem(const std::vector<double>& times, const std::vector<double>& values) {
  if (times.size() != values.size())
    return fmt::format("{} times for {} values", times.size(), values.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]) || !std::isfinite(values[i]))
      return fmt::format("entry {}: {} at {} s is not finite", i + 1, values[i], times[i]);
    if (i > 0 && times[i] <= times[i - 1])
      return fmt::format("entry {}: {} s does not come after {} s", i + 1, times[i], times[i - 1]);
  }
  return "";
}

Schedule make_schedule(Interpolation interpolation, std::vector<double> times,
                       std::vector<double> values) {
  if (const std::string why = schedule_problem(times, values); !why.empty()) throw InputError(why);
  Schedule s{interpolation, std::move(times), std::move(values), {}, 0.0};
  if (s.times.empty()) return s;
  s.integrals.resize(s.times.size(), 0.0);
  for (std::size_t i = 1; i < s.times.size(); ++i) {
    const bool ramps = interpolation == Interpolation::linear;
    const double mean = ramps ? 0.5 * (s.values[i - 1] + s.values[i]) : s.values[i - 1];
    s.integrals[i] = s.integrals[i - 1] + mean * (s.times[i] - s.times[i - 1]);
  }
  s.integral_at_zero = integral_from_first(s, 0.0);
  return s;
}

Schedule constant(double value) { return make_schedule(Interpolation::stepwise, {0.0}, {value}); }

double value_at(const Schedule& s, double t) {
  if (s.times.empty()) return 0.0;
  const std::size_t after = passed(s, t);
  if (after == 0) return s.values.front();
  const std::size_t i = after - 1;
  if (s.interpolation == Interpolation::stepwise || after == s.times.size()) return s.values[i];
  const double f = (t - s.times[i]) / (s.times[after] - s.times[i]);
  return (1.0 - f) * s.values[i] + f * s.values[after];
}

double integral_to(const Schedule& s, double t) {
  return s.times.empty() ? 0.0 : integral_from_first(s, t) - s.integral_at_zero;
}

}  // namespace tdbd::dynamics
