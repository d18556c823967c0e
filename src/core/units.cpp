#include "core/units.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units/spelling.hpp"
#include "core/units/unit_database.hpp"

namespace tdbd {
namespace {

using units::find_unit;
using units::Unit;
using units::UnitPowers;

/// The dimensions of the program's input, for messages.
constexpr std::array<std::pair<const char*, const char*>, 20> dimension_names{{
    {"1", "a plain number"},
    {"m", "length"},
    {"m2", "area"},
    {"m3", "volume"},
    {"rad", "angle"},
    {"s", "time"},
    {"1/s", "frequency"},
    {"m/s", "speed"},
    {"m/s2", "acceleration"},
    {"rad/s", "angular speed"},
    {"kg", "mass"},
    {"kg/m3", "density"},
    {"N", "force"},
    {"N m", "torque"},
    {"N m/rad", "rotational stiffness"},
    {"N m s/rad", "rotational damping"},
    {"kg m2", "moment of inertia"},
    {"Pa", "pressure"},
    {"W", "power"},
    {"K", "temperature"},
}};

bool same_dimension(const Unit& a, const Unit& b) { return a.powers() == b.powers(); }

/// dimension_names with the powers of their units. They are parsed only once, because reading a
/// case needs them hundreds of times.
const std::vector<std::pair<UnitPowers, const char*>>& named_dimensions() {
  static const auto named = [] {
    std::vector<std::pair<UnitPowers, const char*>> all;
    all.reserve(dimension_names.size());
    for (const auto& [symbol, name] : dimension_names)
      all.emplace_back(find_unit(symbol)->powers(), name);
    return all;
  }();
  return named;
}

/// The name of the dimension, such as "length", or the unit in SI base units if it has no name
/// here.
std::string dimension_of(const Unit& unit) {
  const UnitPowers powers = unit.powers();
  for (const auto& [named, name] : named_dimensions())
    if (named == powers) return name;
  const std::string definition = unit.definition();
  return definition.empty() ? "a unit without dimension"
                            : fmt::format("a unit of dimension {}", definition);
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Whether the unit contains a number other than an exponent ("m2", "s-1", "m^3") or the 1 of
/// "1/s". UDUNITS-2 would multiply by it: "8 1/2 in" would be 8 times half an inch.
bool contains_further_number(std::string_view unit) {
  if (unit.size() > 2 && unit.substr(0, 2) == "1/" && is_letter(unit[2])) unit.remove_prefix(1);
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (!is_digit(unit[i]) || (i > 0 && is_digit(unit[i - 1]))) continue;
    const bool is_signed = i > 0 && (unit[i - 1] == '-' || unit[i - 1] == '+');
    const std::size_t before = i - (is_signed ? 1 : 0);  // end of the text before it
    if (before == 0 || !(is_letter(unit[before - 1]) || unit[before - 1] == '^')) return true;
  }
  return false;
}

/// Parses a unit that the program itself requires.
std::unique_ptr<Unit> requested_unit(const std::string& si_unit) {
  std::unique_ptr<Unit> unit = find_unit(si_unit);
  if (!unit) throw RunError(fmt::format("units: {} is not a unit", si_unit));
  return unit;
}

/// `question`: what may be meant; empty without a guess.
UnitError refused(std::string_view text, const std::string& why, const std::string& si_unit,
                  const std::string& question = {}) {
  const std::string expected = si_unit == "1"
                                   ? describe_unit(si_unit)
                                   : fmt::format("{} or in another unit", describe_unit(si_unit));
  return {fmt::format("\"{}\" ({})", text, why),
          question.empty() ? expected : fmt::format("{}; did you mean {}?", expected, question)};
}

/// A number at the start of a text, the number as written, and the name of the unit after it.
struct Quantity {
  double number = 0.0;
  std::string digits, name;
};

Quantity split(std::string_view text, const std::string& si_unit) {
  const auto [body, question] =
      units::plain_number(trimmed(units::plain_characters(trimmed(text))));
  double number = 0.0;
  const auto [rest, error] = std::from_chars(body.data(), body.data() + body.size(), number);
  if (error == std::errc::result_out_of_range) throw refused(text, "is out of range", si_unit);
  if (error != std::errc()) throw refused(text, "does not start with a number", si_unit);
  if (!std::isfinite(number)) throw refused(text, "is not finite", si_unit);
  const auto length = static_cast<std::size_t>(rest - body.data());
  const std::string name(trimmed(std::string_view(body).substr(length)));
  if (name.empty() && si_unit != "1") throw refused(text, "has no unit", si_unit);
  if (!question.empty() && body.find('/') == std::string::npos)
    throw refused(text, "its comma may separate decimals or thousands", si_unit, question);
  if (contains_further_number(name))
    throw refused(text, "has a second number in place of a unit", si_unit, question);
  return {number, body.substr(0, length), name.empty() ? "1" : name};
}

/// The unit of the expected dimension that a name means: the unit of this name, or one of another
/// spelling. Null if there is none.
std::unique_ptr<Unit> unit_of_dimension(const std::string& name, const Unit& target) {
  std::unique_ptr<Unit> unit = find_unit(name);
  if (unit && same_dimension(*unit, target)) return unit;
  for (const std::string& other : units::other_spellings(name)) {
    unit = find_unit(other);
    if (unit && same_dimension(*unit, target)) return unit;
  }
  return nullptr;
}

}  // namespace

UnitError::UnitError(const std::string& found_text, const std::string& expected_text)
    : std::runtime_error(fmt::format("found {}, expected {}", found_text, expected_text)),
      found(found_text),
      expected(expected_text) {}

std::string describe_unit(const std::string& si_unit) {
  if (si_unit == "1") return dimension_names.front().second;
  return fmt::format("{} in {}", dimension_of(*requested_unit(si_unit)), si_unit);
}

double to_si(std::string_view text, const std::string& si_unit) {
  const std::unique_ptr<Unit> target = requested_unit(si_unit);
  const Quantity q = split(text, si_unit);
  const std::unique_ptr<Unit> unit = unit_of_dimension(q.name, *target);
  if (!unit) {
    const std::unique_ptr<Unit> found = find_unit(q.name);
    const std::string why = found ? fmt::format("{} is {}", q.name, dimension_of(*found))
                                  : fmt::format("unknown unit {}", q.name);
    throw refused(text, why, si_unit, units::suggested_units(q.digits, q.name, target->powers()));
  }
  const double value = unit->convert(q.number, *target);
  if (!std::isfinite(value)) throw refused(text, "is out of range in SI", si_unit);
  return value;
}

}  // namespace tdbd
