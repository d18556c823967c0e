#pragma once

#include <vector>

#include "core/config/key_table.hpp"

namespace tdbd::calibration {

/// The tables of a synthetic laboratory that a calibration does not have, for `tdbd keys`.
std::vector<KeyTable> laboratory_tables();

}  // namespace tdbd::calibration
