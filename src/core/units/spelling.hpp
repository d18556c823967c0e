#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/units/unit_database.hpp"

namespace tdbd::units {

/// Replaces typographic characters of a quantity by ASCII: no-break and thin spaces, the minus sign,
/// the middle dot, superscripts, the degree sign and the micro sign.
std::string plain_characters(std::string_view text);

/// The number at the start of a quantity, rewritten so that std::from_chars reads it, and the rest.
struct NumberText {
  std::string text;      ///< of the whole quantity
  std::string question;  ///< not empty: the number is ambiguous; what it may mean
};

/// Rewrites decimal commas ("1,5 mm"), groups of three digits ("1,234,567", "30 000 lbf") and both
/// ("1.234,5") if they have one meaning only. "30,000 lbf" may be 30 000 or 30.000, and "8 1/2 in"
/// contains a fraction; both are questions.
NumberText plain_number(std::string_view text);

/// Units that are probably meant by a name that is no unit, or one of another dimension: "Nm" is
/// "N m", "RPM" is "rpm", "fph" is "ft/h". A spelling is accepted if its unit has the dimension that
/// is expected.
std::vector<std::string> other_spellings(std::string_view name);

/// Units that may be meant by a name with more than one meaning, and are only suggested: "lbs" of a
/// force is "lbf", "mph" is "m/h" or "mile/h". Those of the expected powers, joined by "or"; empty
/// if there is none.
std::string suggested_units(std::string_view number, std::string_view name,
                            const UnitPowers& expected);

}  // namespace tdbd::units
