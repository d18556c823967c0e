#include "core/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "core/error.hpp"
#include "core/memory_left.hpp"
#include "core/text.hpp"

namespace tdbd {
namespace {

/// UDUNITS-2 is not made for two threads at once: every function that others see holds this.
using UnitsLock = std::lock_guard<std::recursive_mutex>;

std::recursive_mutex& units_mutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

using Unit = std::unique_ptr<ut_unit, decltype(&ut_free)>;

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

/// What UDUNITS-2 may need for its database, and for a text, bytes: where it gets none it crashes.
constexpr std::size_t memory_of_database = 8'000'000, memory_of_text = 1'000'000;

Unit parse_unit(ut_system* system, const std::string& text) {
  demand_memory(memory_of_text);
  return {ut_parse(system, text.c_str(), UT_ASCII), &ut_free};
}

/// Adds a name that UDUNITS-2 lacks; one that it already has keeps its meaning.
void add_alias(ut_system* system, const char* name, const std::string& definition) {
  if (parse_unit(system, name)) return;
  const Unit unit = parse_unit(system, definition);
  ut_map_name_to_unit(name, UT_ASCII, unit.get());
}

/// The database that the library came with. UDUNITS2_XML_PATH, which would change units without a word, only counts where
/// there is none.
ut_system* read_database() {
  constexpr const char* variable = "UDUNITS2_XML_PATH";
  const char* elsewhere = std::getenv(variable);
  if (elsewhere == nullptr) return ut_read_xml(nullptr);
  const std::string path = elsewhere;
  unsetenv(variable);
  ut_system* system = ut_read_xml(nullptr);
  setenv(variable, path.c_str(), 1);
  return system != nullptr ? system : ut_read_xml(nullptr);
}

ut_system* load_units() {
  demand_memory(memory_of_database);
  ut_set_error_message_handler(&ut_ignore);
  ut_system* system = read_database();
  if (system == nullptr) throw RunError("units: the database of UDUNITS-2 cannot be read");
  add_alias(system, "deg", "arc_degree");
  add_alias(system, "rev", "revolution");
  add_alias(system, "rpm", "revolution/minute");
  add_alias(system, "lbf", "pound_force");
  add_alias(system, "klbf", "1000 pound_force");
  add_alias(system, "psi", "pound_force/inch^2");
  add_alias(system, "ppg", "pound/(231 inch^3)");
  return system;
}

/// Loaded once and kept until the program ends.
ut_system* unit_system() {
  static ut_system* const system = load_units();
  return system;
}

/// Powers of the base units. We compare dimensions ourselves, since UDUNITS-2 treats the radian as a plain number and
/// converts seconds to 1/s by taking the reciprocal.
using Dimension = std::map<std::string, int>;

void add_power(const ut_unit* base, int power, void* dimension) {
  const char* symbol = ut_get_symbol(base, UT_ASCII);
  const char* name = symbol != nullptr ? symbol : ut_get_name(base, UT_ASCII);
  (*static_cast<Dimension*>(dimension))[name != nullptr ? name : "?"] += power;
}

/// Collects the dimension of a unit: a base unit, powers of base units, or one of these scaled and shifted.
ut_visitor dimension_visitor() {
  ut_visitor visitor{};
  visitor.visit_basic = [](const ut_unit* base, void* dimension) {
    add_power(base, 1, dimension);
    return UT_SUCCESS;
  };
  visitor.visit_product = [](const ut_unit*, int count, const ut_unit* const* bases,
                             const int* powers, void* dimension) {
    for (int i = 0; i < count; ++i) add_power(bases[i], powers[i], dimension);
    return UT_SUCCESS;
  };
  visitor.visit_galilean = [](const ut_unit*, double, const ut_unit* inner, double, void* result) {
    const ut_visitor again = dimension_visitor();
    return ut_accept_visitor(inner, &again, result);
  };
  visitor.visit_timestamp = [](const ut_unit*, const ut_unit*, double, void* dimension) {
    ++(*static_cast<Dimension*>(dimension))["date"];
    return UT_SUCCESS;
  };
  visitor.visit_logarithmic = [](const ut_unit*, double, const ut_unit*, void* dimension) {
    ++(*static_cast<Dimension*>(dimension))["logarithm"];
    return UT_SUCCESS;
  };
  return visitor;
}

Dimension powers_of(const Unit& unit) {
  const ut_visitor visitor = dimension_visitor();
  Dimension powers;
  ut_accept_visitor(unit.get(), &visitor, &powers);
  return powers;
}

bool same_dimension(const Unit& a, const Unit& b) { return powers_of(a) == powers_of(b); }

/// dimension_names with the powers of their units, parsed once: a case asks for hundreds.
const std::vector<std::pair<Dimension, const char*>>& named_dimensions() {
  static const auto named = [] {
    std::vector<std::pair<Dimension, const char*>> all;
    all.reserve(dimension_names.size());
    for (const auto& [symbol, name] : dimension_names)
      all.emplace_back(powers_of(parse_unit(unit_system(), symbol)), name);
    return all;
  }();
  return named;
}

/// "length", or the unit in SI base units when the dimension has no name here.
std::string dimension_of(const Unit& unit) {
  const Dimension powers = powers_of(unit);
  for (const auto& [named, name] : named_dimensions())
    if (named == powers) return name;
  std::array<char, 128> buffer{};
  const int n = ut_format(unit.get(), buffer.data(), buffer.size(), UT_ASCII | UT_DEFINITION);
  return n > 0 ? fmt::format("a unit of dimension {}", buffer.data()) : "a unit without dimension";
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Whether the unit contains a number other than as an exponent ("m2", "s-1", "m^3") or as the 1
/// of "1/s". UDUNITS-2 would multiply by it: "8 1/2 in" would be 8 times half an inch.
bool has_second_number(std::string_view unit) {
  if (unit.size() > 2 && unit.substr(0, 2) == "1/" && is_letter(unit[2])) unit.remove_prefix(1);
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (!is_digit(unit[i]) || (i > 0 && is_digit(unit[i - 1]))) continue;
    const bool is_signed = i > 0 && (unit[i - 1] == '-' || unit[i - 1] == '+');
    const std::size_t before = i - (is_signed ? 1 : 0);  // one past what the number belongs to
    if (before == 0 || !(is_letter(unit[before - 1]) || unit[before - 1] == '^')) return true;
  }
  return false;
}

/// The unit that the program itself requests.
Unit wanted_unit(const std::string& si_unit) {
  Unit unit = parse_unit(unit_system(), si_unit);
  if (!unit) throw RunError(fmt::format("units: {} is no unit", si_unit));
  return unit;
}

UnitError refused(std::string_view text, const std::string& why, const std::string& si_unit) {
  return {fmt::format("\"{}\" ({})", text, why),
          si_unit == "1" ? describe_unit(si_unit)
                         : fmt::format("{} or another unit of it", describe_unit(si_unit))};
}

/// The number at the start of the text, and the name of the unit after it.
std::pair<double, std::string> split(std::string_view text, const std::string& si_unit) {
  const std::string_view body = trimmed(text);
  double number = 0.0;
  const auto [rest, error] = std::from_chars(body.data(), body.data() + body.size(), number);
  if (error == std::errc::result_out_of_range) throw refused(text, "is out of range", si_unit);
  if (error != std::errc()) throw refused(text, "does not start with a number", si_unit);
  if (!std::isfinite(number)) throw refused(text, "is not finite", si_unit);
  const std::string name(trimmed(body.substr(static_cast<std::size_t>(rest - body.data()))));
  if (name.empty() && si_unit != "1") throw refused(text, "has no unit", si_unit);
  if (has_second_number(name))
    throw refused(text, "has a second number in place of a unit", si_unit);
  return {number, name.empty() ? "1" : name};
}

double convert(double x, const Unit& from, const Unit& to) {
  const std::unique_ptr<cv_converter, decltype(&cv_free)> converter{
      ut_get_converter(from.get(), to.get()), &cv_free};
  return cv_convert_double(converter.get(), x);
}

}  // namespace

UnitError::UnitError(const std::string& found_text, const std::string& expected_text)
    : std::runtime_error(fmt::format("found {}, expected {}", found_text, expected_text)),
      found(found_text),
      expected(expected_text) {}

std::string describe_unit(const std::string& si_unit) {
  const UnitsLock lock(units_mutex());
  if (si_unit == "1") return dimension_names.front().second;
  return fmt::format("{} in {}", dimension_of(wanted_unit(si_unit)), si_unit);
}

double to_si(std::string_view text, const std::string& si_unit) {
  const UnitsLock lock(units_mutex());
  const Unit target = wanted_unit(si_unit);
  const auto [number, name] = split(text, si_unit);
  const Unit unit = parse_unit(unit_system(), name);
  if (!unit) throw refused(text, fmt::format("unknown unit {}", name), si_unit);
  if (!same_dimension(unit, target))
    throw refused(text, fmt::format("{} is {}", name, dimension_of(unit)), si_unit);
  const double value = convert(number, unit, target);
  if (!std::isfinite(value)) throw refused(text, "is out of range in SI", si_unit);
  return value;
}

}  // namespace tdbd
