#pragma once

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

namespace tdbd {

/// Invalid input; exit code 2. The message states file, line, key, found and expected.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An output folder cannot be used: it is locked, not empty, not written by TDBD, or not writable.
struct FolderError : InputError {
  using InputError::InputError;
};

/// A failed computation (a broken invariant, an exceeded bound, a full disk); exit code 1.
struct RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The message of an exception; "out of memory" for std::bad_alloc. Allocates nothing; valid as
/// long as `e`.
inline const char* error_message_of(const std::exception& e) {
  return dynamic_cast<const std::bad_alloc*>(&e) != nullptr ? "out of memory" : e.what();
}

/// Whether the error is a lack of a resource (disk, memory, file descriptors) rather than invalid
/// input.
inline bool is_resource_error(const std::error_code& error) {
  for (const std::errc of :
       {std::errc::no_space_on_device, std::errc::too_many_files_open,
        std::errc::too_many_files_open_in_system, std::errc::not_enough_memory,
        std::errc::file_too_large, std::errc::io_error, std::errc::read_only_file_system})
    if (error == of) return true;
  return false;
}

/// Whether the process can allocate `bytes` more memory.
inline bool has_memory(std::size_t bytes) noexcept {
  void* volatile block = std::malloc(bytes);  // volatile, or the compiler removes it
  std::free(block);
  return block != nullptr;
}

/// Throws std::bad_alloc if the process cannot allocate `bytes`. Call it before library functions
/// that crash when memory runs out.
inline void require_allocatable(std::size_t bytes) {
  if (!has_memory(bytes)) throw std::bad_alloc();
}

}  // namespace tdbd
