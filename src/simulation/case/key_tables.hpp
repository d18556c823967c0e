#pragma once

#include <vector>

#include "core/config/key_table.hpp"

namespace tdbd::simulation {

/// Every table of an input file: of cases of `tdbd run`, then of `tdbd rotate`, then of bit files. A
/// new key is declared in one of the headers *_keys.hpp and put into its table in key_tables.cpp or
/// bit/files/bit_tables.cpp; its reader reads it by that declaration.
std::vector<KeyTable> all_tables();

}  // namespace tdbd::simulation
