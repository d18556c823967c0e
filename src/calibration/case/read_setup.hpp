#pragma once

#include <vector>

#include "calibration/case/calibration_case.hpp"
#include "core/config/config.hpp"

namespace tdbd::calibration {

// What a calibration and a synthetic laboratory have in common. Mistakes are noted in the Config.

/// The tools that [bits] and [cutters] give, sorted by name.
std::vector<Tool> read_tools(Config& c);

/// The rock of [rock] and those of [rocks.NAME].
TestRock read_test_rock(Config& c);

/// [noise].
Noise read_noise(Config c);

/// The grid of the cut runs, from [rock] and [time].
CutGrid read_grid(Config& c);

}  // namespace tdbd::calibration
