#pragma once

#include <span>

namespace tdbd::dynamics {

/// Orders that a composition is known for.
inline constexpr int composition_orders[] = {2, 4, 6, 8};

/// Fractions of the step that the stages of a symmetric composition take; they sum to 1. Applied to
/// a symmetric second-order step they give order 2 (one stage), 4 (five: Suzuki, 1990), 6 (nine:
/// Kahan and Li, 1997) or 8 (seventeen: Kahan and Li, 1997). Throws RunError for another order.
std::span<const double> composition(int order);

}  // namespace tdbd::dynamics
