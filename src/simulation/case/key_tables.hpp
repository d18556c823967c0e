#pragma once

#include <vector>

#include "core/config/key_table.hpp"

namespace tdbd::simulation {

/// Every table that a case may have, of `tdbd run` first, then of `tdbd rotate`. A new key stands
/// in one of the headers *_keys.hpp and in its table here; its reader reads it by that declaration.
std::vector<KeyTable> all_tables();

}  // namespace tdbd::simulation
