#include "sweep/table/filter.hpp"

#include <fmt/format.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tdbd::sweep {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

double figure_of(const PointRecord* point, std::size_t figure) {
  return point == nullptr ? no_number : point->outcome.figures[figure];
}

/// The values of a filter and the drilled figures of the same points.
struct Pairs {
  std::vector<double> filter, figure;

  void add(double of_filter, double drilled) {
    if (!std::isfinite(of_filter) || !std::isfinite(drilled)) return;
    filter.push_back(of_filter);
    figure.push_back(drilled);
  }
  long count() const { return std::ssize(filter); }
};

/// The direction in which a figure of the design improves: that of its goal, else that of the
/// filter.
Sense sense_of(const Design& d, const std::string& figure) {
  for (const Goal& goal : d.goals)
    if (goal.figure == figure) return goal.sense;
  return d.filter->goal.sense;
}

}  // namespace

Judged judged_by(const Filter& filter, std::vector<double> figure) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < figure.size(); ++i)
    if (std::isfinite(figure[i])) order.push_back(i);
  const double sign = filter.goal.sense == Sense::smaller ? 1.0 : -1.0;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return sign * figure[i]; });
  Judged judged{.figure = std::move(figure)};
  judged.kept.assign(judged.figure.size(), KeptAs::left_out);
  const auto best = std::min(order.size(), static_cast<std::size_t>(filter.keep));
  for (std::size_t k = 0; k < best; ++k) judged.kept[order[k]] = KeptAs::best;
  const std::size_t rest = order.size() - best;
  const auto samples = std::min(rest, static_cast<std::size_t>(sample_count(filter)));
  for (std::size_t k = 0; k < samples; ++k)
    judged.kept[order[best + (2 * k + 1) * rest / (2 * samples)]] = KeptAs::sample;
  return judged;
}

double rank_correlation(std::span<const double> a, std::span<const double> b) {
  constexpr long fewest = 3;
  Pairs pairs;
  for (std::size_t i = 0; i < a.size(); ++i) pairs.add(a[i], b[i]);
  const auto [low_a, high_a] = std::ranges::minmax_element(pairs.filter);
  const auto [low_b, high_b] = std::ranges::minmax_element(pairs.figure);
  if (pairs.count() < fewest || *low_a == *high_a || *low_b == *high_b) return no_number;
  std::vector<double> work(2 * pairs.filter.size());
  return gsl_stats_spearman(pairs.filter.data(), 1, pairs.figure.data(), 1, pairs.filter.size(),
                            work.data());
}

std::size_t compared_figure(const Design& d) {
  auto found = std::ranges::find(d.figures, d.filter->goal.figure);
  if (found == d.figures.end() && !d.goals.empty())
    found = std::ranges::find(d.figures, d.goals.front().figure);
  return found == d.figures.end() ? 0 : static_cast<std::size_t>(found - d.figures.begin());
}

FilterReport filter_report(const Design& d, const Judged& judged,
                           std::span<const PointRecord* const> points,
                           const PointRecord* unchanged) {
  const std::size_t compared = compared_figure(d);
  FilterReport r;
  r.filter = "planar." + d.filter->goal.figure;
  r.figure = d.figures[compared];
  r.unchanged_filter = judged.unchanged;
  r.unchanged_figure = figure_of(unchanged, compared);
  if (unchanged != nullptr) r.unchanged_message = unchanged->outcome.message;
  const double sign = sense_of(d, r.figure) == Sense::smaller ? 1.0 : -1.0;
  Pairs all, best;
  all.add(r.unchanged_filter, r.unchanged_figure);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double figure = figure_of(points[i], compared);
    if (!judged.keeps(i) || !std::isfinite(figure)) continue;
    all.add(judged.figure[i], figure);
    if (judged.kept[i] == KeptAs::best) best.add(judged.figure[i], figure);
    if (r.best_point < 0 || sign * figure < sign * r.best_figure) {
      r.best_point = static_cast<long>(i);
      r.best_figure = figure;
    }
  }
  r.points = all.count();
  r.best = best.count();
  r.of_all = rank_correlation(all.filter, all.figure);
  r.of_best = rank_correlation(best.filter, best.figure);
  return r;
}

std::string filter_csv(const Design& d, const Judged& judged,
                       std::span<const PointRecord* const> points, const PointRecord* unchanged) {
  const auto number = [](double x) { return std::isfinite(x) ? fmt::format("{}", x) : "nan"; };
  const auto row = [&](const std::string& why, const std::string& point, double filter,
                       const PointRecord* record) {
    std::string text = fmt::format("{},{},{}", why, point, number(filter));
    for (std::size_t k = 0; k < d.figures.size(); ++k) text += "," + number(figure_of(record, k));
    return text + "\n";
  };
  std::string text = "run as,point,planar." + d.filter->goal.figure;
  for (const std::string& figure : d.figures) text += "," + figure;
  text += "\n" + row("unchanged", "", judged.unchanged, unchanged);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (judged.keeps(i))
      text += row(judged.kept[i] == KeptAs::best ? "best" : "sample", fmt::format("{}", i),
                  judged.figure[i], points[i]);
  return text;
}

}  // namespace tdbd::sweep
