#pragma once

#include <numbers>

namespace tdbd {

/// Angles in rad.
inline constexpr double pi = std::numbers::pi;
inline constexpr double full_turn = 2.0 * std::numbers::pi;
inline constexpr double right_angle = 0.5 * std::numbers::pi;
inline constexpr double degree = std::numbers::pi / 180.0;

}  // namespace tdbd
