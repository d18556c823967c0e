#include "verification/battery/counted_memory.hpp"

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> held{0}, peak{0};

void* counted(void* p) {
  if (p == nullptr) throw std::bad_alloc();
  const long now = held += static_cast<long>(malloc_usable_size(p));
  if (now > peak) peak = now;
  return p;
}

void release(void* p) {
  held -= static_cast<long>(malloc_usable_size(p));
  std::free(p);
}

std::size_t rounded_up(std::size_t size, std::size_t alignment) {
  return (size + alignment - 1) / alignment * alignment;
}

}  // namespace

void* operator new(std::size_t size) {
  return counted(std::malloc(std::max<std::size_t>(size, 1)));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  void* p = std::malloc(std::max<std::size_t>(size, 1));
  return p == nullptr ? p : counted(p);
}
void* operator new(std::size_t size, std::align_val_t align) {
  const auto alignment = static_cast<std::size_t>(align);
  return counted(std::aligned_alloc(alignment, rounded_up(size, alignment)));
}
void operator delete(void* p) noexcept { release(p); }
void operator delete(void* p, std::size_t) noexcept { release(p); }
void operator delete(void* p, std::align_val_t) noexcept { release(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { release(p); }

namespace tdbd::battery {

CountedMemory counted_memory() { return {held, peak}; }

void reset_peak() { peak = held.load(); }

}  // namespace tdbd::battery
