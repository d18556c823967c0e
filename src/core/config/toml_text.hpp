#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/types.hpp"

namespace tdbd {

/// A text as a TOML string, quoted and escaped.
std::string toml_string(std::string_view text);

/// Texts as a TOML array.
std::string toml_texts(const std::vector<std::string>& texts);

/// A vector as a TOML array: the shortest digits that read back to the same bits. Empty if a
/// component is not finite.
std::string toml_vector(const Vec3& v);

}  // namespace tdbd
