#pragma once

#include <fmt/format.h>

#include <string>

#include "core/angles.hpp"

namespace tdbd::bit {

/// Formats a length in m for messages: "12.5 mm".
inline std::string mm_text(double x) { return fmt::format("{:.6g} mm", 1e3 * x); }

/// Formats an angle in rad for messages: "20 deg".
inline std::string degree_text(double x) { return fmt::format("{:.6g} deg", x / degree); }

}  // namespace tdbd::bit
