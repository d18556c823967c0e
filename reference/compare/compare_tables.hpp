#pragma once

#include <vector>

#include "core/config/key_table.hpp"

namespace tdbd::reference {

/// Returns the keys of [compare].
std::vector<KeyTable> compare_tables();

}  // namespace tdbd::reference
