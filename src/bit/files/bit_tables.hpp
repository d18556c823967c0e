#pragma once

#include <vector>

#include "core/config/key_table.hpp"

namespace tdbd::bit {

/// Returns every table that a bit file may have (pdc_keys.hpp, design_keys.hpp, cone_keys.hpp,
/// mesh_keys.hpp).
std::vector<KeyTable> bit_tables();

}  // namespace tdbd::bit
