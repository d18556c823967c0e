#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// The cutters as a table with every column, which read_cutter_table reads back to the same values
/// to the last bit, if they came from a table with these columns or from a generator. `bit` fills
/// the first column.
std::string cutter_table_text(const std::string& bit, const std::vector<Cutter>& cutters);

}  // namespace tdbd::bit
