#pragma once

#include <cstdint>
#include <vector>

#include "bit/bit.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// The bit after the start of waiting parts (bit::Part::start). `started` has one entry per part,
/// or is empty if no part waits.
bit::Bit started_bit(bit::Bit bit, const std::vector<std::uint8_t>& started);

/// Whether any part of the bit is still waiting.
bool any_waits(const bit::Bit& bit, const std::vector<std::uint8_t>& started);

/// Starts the parts whose event occurs before the middle of the next step. A start is permanent: it
/// is not undone if the bit lifts. The rock inside a part that starts is removed in that step as if
/// swept. Throws RunError if the centre of a part that starts to cut is below the rock's surface,
/// where rock cannot be removed.
void start_due_parts(const Case& c, State& state, Work& work);

}  // namespace tdbd::simulation
