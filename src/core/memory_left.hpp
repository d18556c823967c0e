#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

namespace tdbd {

/// Whether the process can still get this much memory, bytes.
inline bool has_memory(std::size_t bytes) noexcept {
  void* volatile block = std::malloc(bytes);  // volatile: an unused block would not be asked for
  std::free(block);
  return block != nullptr;
}

/// Throws std::bad_alloc unless it can: before calls to a library that crashes where memory ends.
inline void demand_memory(std::size_t bytes) {
  if (!has_memory(bytes)) throw std::bad_alloc();
}

}  // namespace tdbd
