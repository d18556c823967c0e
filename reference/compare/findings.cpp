#include "reference/compare/findings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace tdbd::reference {
namespace {

constexpr double averaged = 5e-3;  // s

double work_of_a_turn(double weight, double torque, double advance) {
  return torque + weight * advance / (2.0 * std::numbers::pi);
}

}  // namespace

PartLevel level_of(const PartFinding& finding) {
  const std::string& name = finding.part;
  if (name.find("/tooth-") != std::string::npos) return PartLevel::tooth;
  if (name.find("/row-") != std::string::npos) return PartLevel::row;
  return name.starts_with("cutter-") ? PartLevel::cutter : PartLevel::cone;
}

void say(Findings& f, Quantity q, double value) {
  if (std::isfinite(value))
    saying(f, q) = {value, {}};
  else
    saying(f, q) = {std::nullopt, "its number is not finite"};
}

void set_missing(Findings& f, Quantity q, const std::string& reason) {
  saying(f, q) = {std::nullopt, reason};
}

void set_missing(Findings& f, const std::vector<Quantity>& quantities, const std::string& reason) {
  for (const Quantity q : quantities)
    if (const QuantityResult& s = saying(f, q); !s.value && s.reason.empty())
      set_missing(f, q, reason);
}

Noise noise_of(const std::vector<double>& values, std::size_t steps_together) {
  const std::size_t groups = values.size() / std::max<std::size_t>(1, steps_together);
  if (groups == 0) return {};
  std::vector<double> means(groups);
  for (std::size_t g = 0; g < groups; ++g) {
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(g * steps_together);
    means[g] = std::accumulate(from, from + static_cast<std::ptrdiff_t>(steps_together), 0.0) /
               static_cast<double>(steps_together);
  }
  const double n = static_cast<double>(groups);
  const double mean = std::accumulate(means.begin(), means.end(), 0.0) / n;
  double squares = 0.0;
  for (const double m : means) squares += (m - mean) * (m - mean);
  return {mean, mean == 0.0 ? 0.0 : std::sqrt(squares / n) / std::abs(mean)};
}

void set_load_quantities(Findings& f, const LoadSeries& series, double advance) {
  const double weight = noise_of(series.weight, 1).mean;
  const Noise torque = noise_of(series.torque, 1);
  const auto together = static_cast<std::size_t>(std::lround(averaged / series.step));
  say(f, Quantity::weight, weight);
  say(f, Quantity::torque, torque.mean);
  say(f, Quantity::work_of_a_turn_torque, work_of_a_turn(weight, torque.mean, advance));
  say(f, Quantity::torque_noise, torque.share);
  if (together >= 1)
    say(f, Quantity::torque_noise_5ms, noise_of(series.torque, together).share);
  else
    set_missing(f, Quantity::torque_noise_5ms, "its step is longer than 5 ms");
  f.series = series;
}

void set_steady_load_quantities(Findings& f, double weight, double torque, double advance) {
  say(f, Quantity::weight, weight);
  say(f, Quantity::torque, torque);
  say(f, Quantity::work_of_a_turn_torque, work_of_a_turn(weight, torque, advance));
  set_missing(
      f, {Quantity::torque_noise, Quantity::torque_noise_5ms, Quantity::torque_noise_by_crossing},
      "steady: one state for all times");
}

}  // namespace tdbd::reference
