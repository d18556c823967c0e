#pragma once

#include <vector>

#include "core/config/key_table.hpp"

namespace tdbd::sweep {

/// Returns the tables of a design, for `tdbd keys --design`.
std::vector<KeyTable> design_tables();

}  // namespace tdbd::sweep
