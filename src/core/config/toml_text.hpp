#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/types.hpp"

namespace tdbd {

/// Formats a text as a TOML string, quoted and escaped.
std::string toml_string(std::string_view text);

/// Formats texts as a TOML array.
std::string toml_texts(const std::vector<std::string>& texts);

/// Formats a vector as a TOML array, with the shortest digits that read back to the same numbers.
/// Empty if a component is not finite.
std::string toml_vector(const Vec3& v);

}  // namespace tdbd
