#pragma once

#include "core/config/key.hpp"

/// Ranges of a bit's settings. Values outside them are mistakes of units, and their products with
/// others may overflow.
namespace tdbd::bit {

inline constexpr double largest_bit = 10.0;  ///< m
inline constexpr Range bit_length{.lo = 0.0, .hi = largest_bit, .ends = Range::Ends::open_lo};
inline constexpr Range bit_length_or_none = Range::within(0.0, largest_bit);
inline constexpr Range bit_place = Range::within(-largest_bit, largest_bit);

/// kg/m3; the densest element has 22 600.
inline constexpr Range any_density = Range::within(0.0, 3e4);

}  // namespace tdbd::bit
