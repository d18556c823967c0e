#include "sweep/design/levels.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "core/text.hpp"
#include "sweep/design/design_keys.hpp"

namespace tdbd::sweep {

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

Interval read_interval(Config& factor) {
  const Level from = level_of(factor.word(factor_keys::from, {}));
  const Level to = level_of(factor.word(factor_keys::to, {}));
  Interval i{from.number.value_or(0.0), to.number.value_or(1.0), from.unit,
             factor.read(factor_keys::scale)};
  if (factor.problem_count() > 0) return i;
  const auto expect = [&](bool right, std::string_view key, const std::string& found,
                          const char* expected) {
    if (!right) factor.problem(key, found, expected);
  };
  expect(from.number.has_value(), factor_keys::from, from.word.text,
         "a number, with a unit or without");
  expect(to.number.has_value(), factor_keys::to, to.word.text, "a number, with a unit or without");
  if (factor.problem_count() > 0) return i;
  expect(from.unit == to.unit, factor_keys::to, to.word.text, "the unit of from");
  expect(from.unit != to.unit || i.from < i.to, factor_keys::to, to.word.text, "more than from");
  expect(i.scale == Scale::linear || i.from > 0.0, factor_keys::from, from.word.text,
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

}  // namespace tdbd::sweep
