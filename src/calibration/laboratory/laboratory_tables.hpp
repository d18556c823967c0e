#pragma once

#include <vector>

#include "core/config/key_table.hpp"

namespace tdbd::calibration {

/// The tables of a synthetic laboratory that are not tables of a calibration, for `tdbd keys`.
std::vector<KeyTable> laboratory_tables();

}  // namespace tdbd::calibration
