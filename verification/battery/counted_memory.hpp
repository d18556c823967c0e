#pragma once

/// Counts what operator new hands out in a program that links counted_memory.cpp, whose operators
/// take the place of the library's.
namespace tdbd::battery {

/// Bytes that are held now, as the allocator rounds them, and the most since the last reset.
struct CountedMemory {
  long held = 0;
  long peak = 0;
};

CountedMemory counted_memory();

/// The peak starts again from what is held now.
void reset_peak();

}  // namespace tdbd::battery
