#pragma once

#include <exception>
#include <new>
#include <system_error>

namespace tdbd {

/// What went wrong, in words, as long as `e` lives; std::bad_alloc has none of its own. Takes no memory.
inline const char* reason_of(const std::exception& e) {
  return dynamic_cast<const std::bad_alloc*>(&e) != nullptr ? "out of memory" : e.what();
}

/// Whether the machine has too little of something (disk, memory, descriptors), which is no mistake of the input.
inline bool is_shortage(const std::error_code& error) {
  for (const std::errc of :
       {std::errc::no_space_on_device, std::errc::too_many_files_open,
        std::errc::too_many_files_open_in_system, std::errc::not_enough_memory,
        std::errc::file_too_large, std::errc::io_error, std::errc::read_only_file_system})
    if (error == of) return true;
  return false;
}

}  // namespace tdbd
