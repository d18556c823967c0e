#include "core/config/number_doubts.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>

#include "core/units.hpp"

namespace tdbd {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// What a quantity of one SI unit usually is, and the units in which people write it.
struct UsualUnit {
  std::string_view si_unit;
  double least = 0.0, most = no_limit;  ///< SI, without sign
  std::array<std::string_view, 4> written;
};

constexpr std::array<UsualUnit, 14> usual_units{{
    {"1", 0.0, no_limit, {"%"}},
    {"m", 1e-7, 20e3, {"mm", "in"}},
    {"m2", 0.0, 1.0, {"mm2", "in2"}},
    {"s", 0.0, no_limit, {"ms"}},
    {"rad", 0.0, 2.0 * std::numbers::pi, {"deg"}},
    {"m/s", 0.0, 3.0, {"m/h", "ft/h", "mm/s"}},
    {"m/s2", 0.0, 30.0, {"ft/s2"}},
    {"rad/s", 0.0, 35.0, {"rpm", "deg/s"}},
    {"N", 20.0, no_limit, {"klbf", "kN"}},
    {"N m", 20.0, no_limit, {"kN m", "ft klbf"}},
    {"Pa", 9e4, no_limit, {"psi", "bar", "MPa", "GPa"}},
    {"kg/m3", 100.0, 25e3, {"g/cm3", "ppg"}},
    {"kg/m", 0.0, 2e3, {"lb/ft"}},
    {"K", 200.0, 3e3, {"degC"}},
}};

const UsualUnit* find_usual(std::string_view si_unit) {
  for (const UsualUnit& u : usual_units)
    if (u.si_unit == si_unit) return &u;
  return nullptr;
}

bool is_limited(const Range& r) { return std::isfinite(r.lo) || std::isfinite(r.hi); }

bool is_usual(double x, const Range& usual) {
  return x == 0.0 || (std::abs(x) >= usual.lo && std::abs(x) <= usual.hi);
}

}  // namespace

Range usual_values(const std::string& si_unit, const Range& allowed, const Range& declared) {
  constexpr double largest_bit = 10.0, usual_bit = 1.5;  // m
  if (is_limited(declared)) return declared;
  const UsualUnit* unit = find_usual(si_unit);
  if (unit == nullptr) return Range::within(0.0, no_limit);
  const bool of_bit = si_unit == "m" && allowed.hi <= largest_bit;
  return Range::within(unit->least, of_bit ? usual_bit : unit->most);
}

std::string units_meant(double x, const std::string& si_unit, const Range& allowed,
                        const Range& usual) {
  std::string all;
  const UsualUnit* unit = find_usual(si_unit);
  if (unit == nullptr) return all;
  constexpr double least_percentage = 3.0;  // smaller numbers are shares beyond their limit
  if (si_unit == "1" && std::abs(x) < least_percentage) return all;
  for (const std::string_view written : unit->written) {
    if (written.empty()) continue;
    try {
      const std::string text = fmt::format("{}{}{}", x, written == "%" ? "" : " ", written);
      const double other = to_si(text, si_unit);
      if (allowed.contains(other) && is_usual(other, usual))
        all += fmt::format("{}\"{}\"", all.empty() ? "" : " or ", text);
    } catch (const UnitError&) {  // beyond the range of numbers
    }
  }
  return all;
}

std::string bare_number_doubt(double x, const std::string& si_unit, const Range& allowed,
                              const Range& declared) {
  const Range usual = usual_values(si_unit, allowed, declared);
  if (si_unit == "1" || is_usual(x, usual)) return "";
  const std::string meant = units_meant(x, si_unit, allowed, usual);
  if (meant.empty()) return "";
  return fmt::format("{0} without a unit is {0} {1}; did you mean {2}?", x, si_unit, meant);
}

}  // namespace tdbd
