#pragma once

#include "core/config/config.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// The table [rock] (keys: README.md). Mistakes are noted in the Config.
RockStart read_rock(Config c);

}  // namespace tdbd::simulation
