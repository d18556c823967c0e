#include "core/program_file.hpp"

#include <dlfcn.h>
#include <link.h>

namespace tdbd {

std::filesystem::path program_file() {
  Dl_info unused{};
  void* found = nullptr;
  const void* here = reinterpret_cast<const void*>(&program_file);
  if (dladdr1(here, &unused, &found, RTLD_DL_LINKMAP) != 0)
    if (const char* name = static_cast<const link_map*>(found)->l_name; *name != '\0') return name;
  return "/proc/self/exe";  // the main program has an empty name in the list
}

}  // namespace tdbd
