#pragma once

#include <vector>

#include "core/config/key_table.hpp"

namespace tdbd::calibration {

/// Returns the tables of a calibration, for `tdbd keys`.
std::vector<KeyTable> calibration_tables();

}  // namespace tdbd::calibration
