#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace tdbd {

/// Version and build of the program, written into every summary.
struct Provenance {
  const char* version;
  const char* commit;
  const char* compiler;
  const char* flags;
};

const Provenance& provenance();

/// The file from which this code was loaded: the program or a shared library.
std::filesystem::path program_file();

/// FNV-1a hash, 64 bits, of the content of a case. It detects mistakes, not forgery.
std::uint64_t fnv1a(std::string_view bytes);

/// The same hash as 16 lower-case hexadecimal digits.
std::string fnv1a_hex(std::string_view bytes);

}  // namespace tdbd
