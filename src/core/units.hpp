#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace tdbd {

/// The text is not a quantity of the expected dimension: what was found, what was expected.
struct UnitError : std::runtime_error {
  UnitError(const std::string& found_text, const std::string& expected_text);
  std::string found;
  std::string expected;
};

/// Reads a number and its unit ("8.5 in", "120 rpm", "20 klbf") and returns the value in `si_unit`
/// ("m", "m/s", "rad/s", "N", "Pa", "rad", "s", "kg/m3", "1"). Unit names are those of UDUNITS-2
/// and the drilling industry's klbf and ppg. A plane angle counts as a dimension: Hz is not rad/s.
/// Throws UnitError: not a finite number, no unit, an unknown unit, a unit of another dimension;
/// RunError if `si_unit` itself is not a unit.
/// Threads may call it at once: they take turns, since UDUNITS-2 knows no threads.
double to_si(std::string_view text, const std::string& si_unit);

/// "length in m": the dimension of an SI unit in words, for messages.
std::string describe_unit(const std::string& si_unit);

}  // namespace tdbd
