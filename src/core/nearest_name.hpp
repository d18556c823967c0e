#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tdbd {

/// Levenshtein distance: the smallest number of insertions, deletions and replacements of characters.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// What a misspelt name most likely meant: the nearest of `names` (the first among equals) if at most a third of the
/// longer one differs, else nothing.
std::optional<std::string> nearest_name(std::string_view name,
                                        const std::vector<std::string>& names);

}  // namespace tdbd
