#pragma once

#include <vector>

#include "calibration/case/calibration_case.hpp"
#include "core/config/config.hpp"

namespace tdbd::calibration {

// Tables that calibrations and synthetic laboratories share. Mistakes are recorded in the Config.

/// Reads the tools in [bits] and [cutters], sorted by name.
std::vector<Tool> read_tools(Config& c);

/// Reads the rock of [rock] and those of [rocks.NAME].
TestRock read_test_rock(Config& c);

/// Reads [noise].
Noise read_noise(Config c);

/// Reads the grid of the cut runs from [rock] and [time].
CutGrid read_grid(Config& c);

}  // namespace tdbd::calibration
