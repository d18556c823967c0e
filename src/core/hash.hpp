#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tdbd {

/// FNV-1a hash, 64 bits, of the content of a case. It detects mistakes, not forgery.
std::uint64_t fnv1a(std::string_view bytes);

/// The same hash as 16 lower-case hexadecimal digits.
std::string fnv1a_hex(std::string_view bytes);

}  // namespace tdbd
