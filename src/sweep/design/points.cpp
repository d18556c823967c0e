#include "sweep/design/points.hpp"

#include <fmt/format.h>
#include <gsl/gsl_qrng.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <numeric>

#include "core/random.hpp"
#include "core/text.hpp"

namespace tdbd::sweep {
namespace {

/// Fills one column: a permutation of the parts, with a random position in each part.
void fill_column(std::vector<std::vector<double>>& rows, std::size_t column, Random& random) {
  const std::size_t n = rows.size();
  std::vector<std::size_t> part(n);
  std::iota(part.begin(), part.end(), std::size_t{0});
  for (std::size_t i = n; i > 1; --i) std::swap(part[i - 1], part[random.next() % i]);
  for (std::size_t i = 0; i < n; ++i)
    rows[i][column] = (static_cast<double>(part[i]) + random.uniform()) / static_cast<double>(n);
}

void fill_sobol(std::vector<std::vector<double>>& rows, std::size_t dimensions) {
  const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> sequence{
      gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(dimensions)), &gsl_qrng_free};
  for (std::vector<double>& row : rows) gsl_qrng_get(sequence.get(), row.data());
}

}  // namespace

Level level_of(const ConfigWord& word) {
  const std::string_view body = trimmed(word.text);
  double number = 0.0;
  const auto [rest, error] = std::from_chars(body.data(), body.data() + body.size(), number);
  if (error != std::errc() || !std::isfinite(number)) return {word};
  const auto used = static_cast<std::size_t>(rest - body.data());
  return {word, number, std::string(trimmed(body.substr(used)))};
}

Level level_at(double number, const std::string& unit) {
  if (!unit.empty()) {
    const std::string text = fmt::format("{} {}", number, unit);
    return {{text, fmt::format("\"{}\"", text)}, number, unit};
  }
  const std::string text = fmt::format("{}", number);
  return {{text, text}, number, unit};
}

Interval interval_of(Config& factor, const FactorSettings& s) {
  const Level from = level_of(s.from), to = level_of(s.to);
  Interval i{from.number.value_or(0.0), to.number.value_or(1.0), from.unit, s.scale};
  if (factor.problem_count() > 0) return i;
  const auto expect = [&](bool right, std::string_view key, const std::string& found,
                          const char* expected) {
    if (!right) factor.problem(key, found, expected);
  };
  expect(from.number.has_value(), "from", from.word.text, "a number, with a unit or without");
  expect(to.number.has_value(), "to", to.word.text, "a number, with a unit or without");
  if (factor.problem_count() > 0) return i;
  expect(from.unit == to.unit, "to", to.word.text, "the unit of from");
  expect(from.unit != to.unit || i.from < i.to, "to", to.word.text, "more than from");
  expect(i.scale == Scale::linear || i.from > 0.0, "from", from.word.text,
         "more than 0 on a logarithmic scale");
  return i;
}

double place_in(const Interval& i, double u) {
  if (u >= 1.0) return i.to;  // exact, like the other end
  return i.scale == Scale::log ? i.from * std::pow(i.to / i.from, u) : i.from + (i.to - i.from) * u;
}

std::vector<Level> levels_in(const Interval& i, long count) {
  std::vector<Level> levels;
  for (long k = 0; k < count; ++k)
    levels.push_back(
        level_at(place_in(i, static_cast<double>(k) / static_cast<double>(count - 1)), i.unit));
  return levels;
}

bool is_sampled(const Factor& f) { return f.interval && f.levels.empty(); }

std::vector<std::vector<double>> samples_of(const Design& d) {
  const auto dimensions = static_cast<std::size_t>(std::ranges::count_if(d.factors, is_sampled));
  if (dimensions == 0) return {};
  std::vector<std::vector<double>> rows(static_cast<std::size_t>(d.samples),
                                        std::vector<double>(dimensions));
  if (d.sampling == Sampling::sobol) {
    fill_sobol(rows, dimensions);
    return rows;
  }
  Random random{d.seed};
  for (std::size_t column = 0; column < dimensions; ++column) fill_column(rows, column, random);
  return rows;
}

Points points_of(const Design& d) {
  Points points{1, samples_of(d)};
  for (const Factor& f : d.factors)
    if (!is_sampled(f)) points.count *= static_cast<long>(f.levels.size());
  if (!points.samples.empty()) points.count *= d.samples;
  return points;
}

std::vector<Level> levels_at(const Design& d, const Points& points, long index) {
  std::vector<Level> levels(d.factors.size());
  const std::vector<double>* row = nullptr;
  if (!points.samples.empty()) {
    row = &points.samples[static_cast<std::size_t>(index % d.samples)];
    index /= d.samples;
  }
  std::size_t column = row == nullptr ? 0 : row->size();
  for (std::size_t i = d.factors.size(); i-- > 0;) {
    const Factor& f = d.factors[i];
    if (is_sampled(f)) {
      levels[i] = level_at(place_in(*f.interval, (*row)[--column]), f.interval->unit);
    } else {
      const auto count = static_cast<long>(f.levels.size());
      levels[i] = f.levels[static_cast<std::size_t>(index % count)];
      index /= count;
    }
  }
  return levels;
}

std::vector<std::string> overrides_at(const Design& d, const Points& points, long index) {
  std::vector<std::string> overrides = d.fixed;
  const std::vector<Level> levels = levels_at(d, points, index);
  for (std::size_t i = 0; i < levels.size(); ++i)
    overrides.push_back(d.factors[i].key + "=" + levels[i].word.toml);
  return overrides;
}

}  // namespace tdbd::sweep
