#include "sweep/curve/rate_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tdbd::sweep {
namespace {

constexpr double farthest_below = 0.4, nearest_below = 0.95;  // of the smallest weight
constexpr double nearest_above = 1.05, farthest_above = 2.5;  // of the largest weight
constexpr double margin = 0.1;                                // of the interval, at either end

/// The first point after which the rate falls by more than the intervals of both rates.
std::optional<std::size_t> falls_after(std::span<const RatePoint> points) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    if (points[i + 1].rate + points[i + 1].interval < points[i].rate - points[i].interval) return i;
  return std::nullopt;
}

/// The weight at which the line through two points has the rate; through the origin if there is only
/// one point or the line does not rise.
double on_line(std::span<const RatePoint> points, std::size_t near, std::size_t other,
               double rate) {
  const RatePoint& a = points[near];
  if (near != other) {
    const RatePoint& b = points[other];
    const double slope = (b.rate - a.rate) / (b.weight - a.weight);
    if (slope > 0.0) return a.weight + (rate - a.rate) / slope;
  }
  return a.rate > 0.0 ? a.weight * rate / a.rate : farthest_above * a.weight;
}

double proposed(std::span<const RatePoint> points, double rate) {
  const std::size_t last = points.size() - 1;
  const RatePoint &first = points.front(), &end = points.back();
  std::size_t above = 0;
  while (above <= last && points[above].rate < rate) ++above;
  if (above > last)
    return std::clamp(on_line(points, last, last > 0 ? last - 1 : 0, rate),
                      nearest_above * end.weight, farthest_above * end.weight);
  if (above == 0)
    return std::clamp(on_line(points, 0, std::min<std::size_t>(1, last), rate),
                      farthest_below * first.weight, nearest_below * first.weight);
  const RatePoint &a = points[above - 1], &b = points[above];
  const double share = (rate - a.rate) / (b.rate - a.rate);
  return std::lerp(a.weight, b.weight, std::clamp(share, margin, 1.0 - margin));
}

}  // namespace

double four_digits(double x) {
  constexpr double digits = 3.0;
  const double exponent = digits - std::floor(std::log10(x));
  // Powers of ten with whole exponents are exact, so a whole number stays a whole number.
  const double unit = std::pow(10.0, std::abs(exponent));
  return exponent >= 0.0 ? std::round(x * unit) / unit : std::round(x / unit) * unit;
}

std::size_t nearest_rate(std::span<const RatePoint> points, double rate) {
  const auto nearest = std::ranges::min_element(
      points, {}, [rate](const RatePoint& p) { return std::abs(p.rate - rate); });
  return static_cast<std::size_t>(nearest - points.begin());
}

bool is_within_reach(std::span<const RatePoint> points, double rate) {
  const auto is_below = [rate](const RatePoint& p) { return p.rate <= rate; };
  const auto is_above = [rate](const RatePoint& p) { return p.rate >= rate; };
  return std::ranges::any_of(points, is_below) && std::ranges::any_of(points, is_above);
}

RateProposal next_weight(std::span<const RatePoint> points, const RateGoal& goal) {
  if (points.empty()) return {SearchStep::run, four_digits(goal.first_weight), 0};
  const std::size_t nearest = nearest_rate(points, goal.rate);
  if (const auto after = falls_after(points)) return {SearchStep::falls, 0.0, *after};
  if (std::abs(points[nearest].rate - goal.rate) <= goal.tolerance * goal.rate)
    return {SearchStep::found, 0.0, nearest};
  const double weight = four_digits(proposed(points, goal.rate));
  const bool was_run =
      std::ranges::any_of(points, [weight](const RatePoint& p) { return p.weight == weight; });
  if (was_run) return {SearchStep::unresolved, 0.0, nearest};
  return {SearchStep::run, weight, 0};
}

}  // namespace tdbd::sweep
