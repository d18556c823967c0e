#pragma once

#include <exception>

namespace tdbd::simulation {

/// Writes what can still be written after a failure; a second failure (the disk is full) leaves the
/// rest unwritten.
template <class Write>
void try_to(Write write) {
  try {
    write();
  } catch (const std::exception&) {  // the first error is the one that is told
  }
}

}  // namespace tdbd::simulation
