#include "core/provenance.hpp"

#include <fmt/format.h>

#ifndef __EMSCRIPTEN__  // a program for browsers has no file of its own
#include <dlfcn.h>
#include <link.h>
#endif

namespace tdbd {

std::uint64_t fnv1a(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char byte : bytes) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 0x100000001b3u;
  }
  return hash;
}

std::string fnv1a_hex(std::string_view bytes) { return fmt::format("{:016x}", fnv1a(bytes)); }

#ifndef __EMSCRIPTEN__
std::filesystem::path program_file() {
  Dl_info unused{};
  void* found = nullptr;
  const void* here = reinterpret_cast<const void*>(&program_file);
  if (dladdr1(here, &unused, &found, RTLD_DL_LINKMAP) != 0)
    if (const char* name = static_cast<const link_map*>(found)->l_name; *name != '\0') return name;
  return "/proc/self/exe";  // the main program has an empty name in the list
}
#endif

}  // namespace tdbd
