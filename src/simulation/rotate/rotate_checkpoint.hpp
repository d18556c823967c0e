#pragma once

#include <filesystem>

#include "simulation/rotate/rotate_simulation.hpp"

namespace tdbd::simulation {

/// How far a rotation has come with its history.
struct RotateWritten {
  long rows = 0;
  long last_step = -1;  ///< of the last row
};

/// A rotation between two steps, as it was saved.
struct RotateCheckpoint {
  RotateSimulation simulation;
  RotateWritten written;
};

/// Writes a checkpoint: complete, on the disk, or not at all. Throws RunError.
void write_rotate_checkpoint(const std::filesystem::path& path, const RotateCase& c,
                             const RotateSimulation& s, const RotateWritten& written);

/// Reads it. Throws like CaseTape.
RotateCheckpoint read_rotate_checkpoint(const std::filesystem::path& path, const RotateCase& c);

}  // namespace tdbd::simulation
