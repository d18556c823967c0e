#pragma once

#include <exception>
#include <new>
#include <system_error>

namespace tdbd {

/// The message of an exception; "out of memory" for std::bad_alloc. Allocates nothing; valid as
/// long as `e`.
inline const char* reason_of(const std::exception& e) {
  return dynamic_cast<const std::bad_alloc*>(&e) != nullptr ? "out of memory" : e.what();
}

/// Whether the error is a lack of a resource (disk, memory, file descriptors) rather than invalid
/// input.
inline bool is_shortage(const std::error_code& error) {
  for (const std::errc of :
       {std::errc::no_space_on_device, std::errc::too_many_files_open,
        std::errc::too_many_files_open_in_system, std::errc::not_enough_memory,
        std::errc::file_too_large, std::errc::io_error, std::errc::read_only_file_system})
    if (error == of) return true;
  return false;
}

}  // namespace tdbd
