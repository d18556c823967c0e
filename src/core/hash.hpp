#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tdbd {

/// FNV-1a, 64 bits: identifies the content of a case. It guards against mistakes, not against forgery.
std::uint64_t fnv1a(std::string_view bytes);

/// The same as 16 lower-case hexadecimal digits.
std::string fnv1a_hex(std::string_view bytes);

}  // namespace tdbd
