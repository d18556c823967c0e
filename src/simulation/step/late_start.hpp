#pragma once

#include <cstdint>
#include <vector>

#include "bit/bit.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// The bit with those waiting parts (bit::Part::start) that have started. `started`: per part, or
/// empty if no part of the bit waits.
bit::Bit started_bit(bit::Bit bit, const std::vector<std::uint8_t>& started);

/// Whether some part of the bit still waits.
bool any_waits(const bit::Bit& bit, const std::vector<std::uint8_t>& started);

/// Starts the parts whose event has come before the middle of the next step, for good: a bit that
/// lifts again does not stop them. The rock inside a part that starts leaves it in that step, as rock
/// that it swept. Throws RunError if the middle of a part that starts to cut lies below the rock's
/// surface, from where no rock can leave.
void start_due_parts(const Case& c, State& state, Work& work);

}  // namespace tdbd::simulation
