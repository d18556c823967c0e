#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

namespace tdbd {

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
