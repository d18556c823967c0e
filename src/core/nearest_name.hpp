#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tdbd {

/// Levenshtein distance: the least number of inserted, deleted and replaced characters.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name that a misspelt one most likely meant: the nearest of `names` (the first of equals)
/// when no more than a third of the longer one differs, else none.
std::optional<std::string> nearest_name(std::string_view name,
                                        const std::vector<std::string>& names);

}  // namespace tdbd
