#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "core/units/unit_database.hpp"

namespace tdbd::units {

namespace {

/// A unit in SI base units: scale times x, plus shift.
struct Measure {
  double scale = 1.0;
  double shift = 0.0;
  UnitPowers powers = {};
};

constexpr double inch = 0.0254, foot = 12 * inch, pound = 0.45359237, gravity = 9.80665;
constexpr double degree = std::numbers::pi / 180.0, turn = 2.0 * std::numbers::pi;

/// Powers of m, kg, s, K, rad.
using Exponents = std::array<int, 5>;
constexpr std::array<const char*, 5> base_names{"m", "kg", "s", "K", "rad"};
constexpr Exponents plain{}, of_length{1}, of_mass{0, 1}, of_time{0, 0, 1}, of_frequency{0, 0, -1},
    of_temperature{0, 0, 0, 1}, of_angle{0, 0, 0, 0, 1}, of_angular_speed{0, 0, -1, 0, 1},
    of_force{1, 1, -2}, of_pressure{-1, 1, -2}, of_energy{2, 1, -2}, of_power{2, 1, -3},
    of_density{-3, 1};

enum class Prefixes { none, symbols, words };

struct Row {
  const char* name;
  double scale;  ///< in SI base units
  Exponents exponents;
  Prefixes prefixes = Prefixes::none;
  double shift = 0.0;
};

constexpr auto rows = std::to_array<Row>({
    {"1", 1.0, plain},
    {"%", 0.01, plain},
    {"percent", 0.01, plain},
    {"m", 1.0, of_length, Prefixes::symbols},
    {"meter", 1.0, of_length, Prefixes::words},
    {"metre", 1.0, of_length, Prefixes::words},
    {"micron", 1e-6, of_length},
    {"in", inch, of_length},
    {"inch", inch, of_length},
    {"ft", foot, of_length},
    {"foot", foot, of_length},
    {"feet", foot, of_length},
    {"yd", 3 * foot, of_length},
    {"yard", 3 * foot, of_length},
    {"g", 1e-3, of_mass, Prefixes::symbols},
    {"gram", 1e-3, of_mass, Prefixes::words},
    {"t", 1e3, of_mass},
    {"tonne", 1e3, of_mass},
    {"lb", pound, of_mass},
    {"pound", pound, of_mass},
    {"s", 1.0, of_time, Prefixes::symbols},
    {"sec", 1.0, of_time},
    {"second", 1.0, of_time, Prefixes::words},
    {"min", 60.0, of_time},
    {"minute", 60.0, of_time},
    {"h", 3600.0, of_time},
    {"hr", 3600.0, of_time},
    {"hour", 3600.0, of_time},
    {"d", 86400.0, of_time},
    {"day", 86400.0, of_time},
    {"Hz", 1.0, of_frequency, Prefixes::symbols},
    {"hertz", 1.0, of_frequency, Prefixes::words},
    {"K", 1.0, of_temperature, Prefixes::symbols},
    {"kelvin", 1.0, of_temperature},
    {"degC", 1.0, of_temperature, Prefixes::none, 273.15},
    {"rad", 1.0, of_angle, Prefixes::symbols},
    {"radian", 1.0, of_angle, Prefixes::words},
    {"deg", degree, of_angle},
    {"degree", degree, of_angle},
    {"arc_degree", degree, of_angle},
    {"rev", turn, of_angle},
    {"revolution", turn, of_angle},
    {"rpm", turn / 60.0, of_angular_speed},
    {"N", 1.0, of_force, Prefixes::symbols},
    {"newton", 1.0, of_force, Prefixes::words},
    {"kgf", gravity, of_force},
    {"lbf", pound* gravity, of_force},
    {"klbf", 1000 * pound* gravity, of_force},
    {"Pa", 1.0, of_pressure, Prefixes::symbols},
    {"pascal", 1.0, of_pressure, Prefixes::words},
    {"bar", 1e5, of_pressure},
    {"atm", 101325.0, of_pressure},
    {"psi", pound* gravity / (inch * inch), of_pressure},
    {"J", 1.0, of_energy, Prefixes::symbols},
    {"joule", 1.0, of_energy, Prefixes::words},
    {"W", 1.0, of_power, Prefixes::symbols},
    {"watt", 1.0, of_power, Prefixes::words},
    {"ppg", pound / (231 * inch * inch * inch), of_density},
});

struct Prefix {
  const char* symbol;
  const char* word;
  double factor;
};

constexpr auto prefixes = std::to_array<Prefix>({{"G", "giga", 1e9},
                                                 {"M", "mega", 1e6},
                                                 {"k", "kilo", 1e3},
                                                 {"d", "deci", 1e-1},
                                                 {"c", "centi", 1e-2},
                                                 {"m", "milli", 1e-3},
                                                 {"u", "micro", 1e-6},
                                                 {"n", "nano", 1e-9}});

Measure unit_of(const Row& row, double factor) {
  Measure unit{row.scale * factor, row.shift, {}};
  for (std::size_t i = 0; i < base_names.size(); ++i)
    if (row.exponents[i] != 0) unit.powers[base_names[i]] = row.exponents[i];
  return unit;
}

const Row* row_named(std::string_view name, bool with_prefix, Prefixes kind) {
  for (const Row& row : rows)
    if (name == row.name && (!with_prefix || row.prefixes == kind)) return &row;
  return nullptr;
}

/// Also finds the plural of words, such as "meters". Symbols have no plural.
const Row* find_row_or_plural(std::string_view name, bool with_prefix, Prefixes kind) {
  if (const Row* row = row_named(name, with_prefix, kind)) return row;
  if (name.size() < 4 || name.back() != 's') return nullptr;
  name.remove_suffix(1);
  return row_named(name, with_prefix, kind);
}

const Row* prefixed_row(std::string_view name, const Prefix& p, bool is_word) {
  const std::string_view start = is_word ? p.word : p.symbol;
  if (name.substr(0, start.size()) != start) return nullptr;
  return find_row_or_plural(name.substr(start.size()), true,
                            is_word ? Prefixes::words : Prefixes::symbols);
}

std::optional<Measure> named_unit(std::string_view name) {
  if (const Row* row = find_row_or_plural(name, false, Prefixes::none)) return unit_of(*row, 1.0);
  for (const Prefix& p : prefixes)
    for (const bool is_word : {false, true})
      if (const Row* row = prefixed_row(name, p, is_word)) return unit_of(*row, p.factor);
  return std::nullopt;
}

bool is_part_of_name(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_' || c == '%';
}

/// Whether the text starts with the 1 of "1/s". No other number is a unit.
bool starts_with_one(std::string_view text) {
  return text.starts_with('1') && text.find_first_of("0123456789.", 1) != 1;
}

/// Parses and removes "m", "m2", "m^2" or "m-1" from the front of a text.
std::optional<Measure> take_factor(std::string_view& text) {
  std::size_t n = 0;
  while (n < text.size() && is_part_of_name(text[n])) ++n;
  if (n == 0 && starts_with_one(text)) n = 1;
  std::optional<Measure> unit = named_unit(text.substr(0, n));
  if (n == 0 || !unit) return std::nullopt;
  text.remove_prefix(n);
  const bool has_sign = text.substr(0, 1) == "^";
  if (has_sign) text.remove_prefix(1);
  int power = 1;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), power);
  if (error != std::errc()) return has_sign ? std::nullopt : unit;
  text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  if (unit->shift != 0.0) return std::nullopt;
  unit->scale = std::pow(unit->scale, power);
  for (auto& [base, exponent] : unit->powers) exponent *= power;
  return unit;
}

void multiply(Measure& unit, const Measure& by, int sign) {
  unit.scale = sign > 0 ? unit.scale * by.scale : unit.scale / by.scale;
  for (const auto& [base, exponent] : by.powers) unit.powers[base] += sign * exponent;
}

std::string_view without_leading_blanks(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

/// Parses the operator before the next factor: +1 for a product, -1 for a quotient, 0 if there is
/// none. Blanks are permitted around every operator except a point.
int take_sign(std::string_view& text) {
  if (!text.empty() && text.front() == '.') {
    text.remove_prefix(1);
    return 1;
  }
  const std::string_view rest = without_leading_blanks(text);
  if (!rest.empty() && (rest.front() == '/' || rest.front() == '*')) {
    const int sign = rest.front() == '/' ? -1 : 1;
    text = without_leading_blanks(rest.substr(1));
    return sign;
  }
  const bool has_blank = rest.size() < text.size();
  text = rest;
  return has_blank ? 1 : 0;
}

std::optional<Measure> parsed(std::string_view text) {
  std::optional<Measure> unit = take_factor(text);
  while (unit && !text.empty()) {
    const int sign = take_sign(text);
    const std::optional<Measure> factor = sign != 0 ? take_factor(text) : std::nullopt;
    if (!factor || unit->shift != 0.0 || factor->shift != 0.0) return std::nullopt;
    multiply(*unit, *factor, sign);
  }
  return unit;
}

class TableUnit final : public Unit {
 public:
  explicit TableUnit(Measure measure) : measure_(std::move(measure)) {
    std::erase_if(measure_.powers, [](const auto& p) { return p.second == 0; });
  }

  UnitPowers powers() const override { return measure_.powers; }

  double convert(double x, const Unit& to) const override {
    const Measure& wanted = static_cast<const TableUnit&>(to).measure_;
    if (measure_.shift == wanted.shift) return x * (measure_.scale / wanted.scale);
    return (x * measure_.scale + measure_.shift - wanted.shift) / wanted.scale;
  }

  std::string definition() const override {
    std::string text;
    for (const auto& [base, power] : measure_.powers)
      text += fmt::format("{}{}{}", text.empty() ? "" : ".", base,
                          power == 1 ? "" : std::to_string(power));
    return measure_.scale == 1.0 ? text : fmt::format("{:g} {}", measure_.scale, text);
  }

 private:
  Measure measure_;
};

}  // namespace

std::unique_ptr<Unit> find_in_table(const std::string& name) {
  std::optional<Measure> unit = parsed(name);
  if (!unit) return nullptr;
  return std::make_unique<TableUnit>(std::move(*unit));
}

}  // namespace tdbd::units
