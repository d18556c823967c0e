#pragma once

#include <string>

#include "core/config/field.hpp"

namespace tdbd {

/// First line of the resolved case in a result folder. It distinguishes this case.toml from one
/// that a user wrote. Its numbers are in SI, so only overrides of it are doubted.
inline constexpr const char* resolved_head =
    "# Resolved by tdbd: every default written out, in SI.";

/// The values (SI, without sign) that a quantity usually has. `declared` has precedence if it has a
/// limit. Otherwise the values depend on the unit: angles up to one turn, forces from 20 N,
/// pressures from 0.09 MPa, angular speeds up to 35 rad/s (334 rpm), and so on. Lengths whose range
/// ends at 10 m belong to a bit and are at most 1.5 m. Zero is always usual.
Range usual_values(const std::string& si_unit, const Range& allowed, const Range& declared);

/// Returns what a bare number may mean that is in SI only because it has no unit: "\"15 m/h\" or
/// \"15 ft/h\"". The units are those in which people write the quantity; listed are those in which
/// the number is allowed and usual. Empty if there are none.
std::string units_meant(double x, const std::string& si_unit, const Range& allowed,
                        const Range& usual);

/// Returns the doubt about a bare number that is unusual in SI and usual in another unit: "15 without
/// a unit is 15 m/s; did you mean ...?". Empty if there is none.
std::string bare_number_doubt(double x, const std::string& si_unit, const Range& allowed,
                              const Range& declared);

}  // namespace tdbd
