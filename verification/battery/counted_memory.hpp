#pragma once

/// Counts the memory that operator new allocates, in a program that links counted_memory.cpp: its
/// operators replace those of the library.
namespace tdbd::battery {

/// Bytes held now, as the allocator rounds them, and the most held since the last reset.
struct CountedMemory {
  long held = 0;
  long peak = 0;
};

CountedMemory counted_memory();

/// Sets the peak to what is held now.
void reset_peak();

}  // namespace tdbd::battery
