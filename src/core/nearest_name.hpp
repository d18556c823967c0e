#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tdbd {

/// Levenshtein distance: the smallest number of insertions, deletions and replacements of
/// characters.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Returns the most likely correction of a misspelt name: the closest of `names` (the first of
/// equally close ones). Returns nothing if more than a third of the longer name differs.
std::optional<std::string> nearest_name(std::string_view name,
                                        const std::vector<std::string>& names);

}  // namespace tdbd
