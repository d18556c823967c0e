#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace tdbd {

/// The text is not a quantity of the expected dimension.
struct UnitError : std::runtime_error {
  UnitError(const std::string& found_text, const std::string& expected_text);
  std::string found;
  std::string expected;
};

/// Reads a number and its unit ("8.5 in", "120 rpm", "20 klbf") and returns the value in `si_unit`
/// ("m", "m/s", "rad/s", "N", "Pa", "rad", "s", "kg/m3", "1"). Unit names are those of UDUNITS-2
/// and the drilling industry's klbf and ppg. Other spellings are accepted if they have one meaning
/// of the expected dimension ("Nm", "RPM", "ft-lb", "1,5 mm", a no-break space; units/spelling.hpp);
/// the message about others suggests one ("30,000 lbf", "20 klb"). A plane angle counts as a
/// dimension: Hz is not rad/s. Throws UnitError if the number is missing or not finite, or if the unit is missing, unknown or
/// of another dimension. Throws RunError if `si_unit` itself is not a unit. Thread-safe; calls are
/// serialized because UDUNITS-2 is not thread-safe.
double to_si(std::string_view text, const std::string& si_unit);

/// Describes the dimension of an SI unit for messages: "length in m".
std::string describe_unit(const std::string& si_unit);

}  // namespace tdbd
