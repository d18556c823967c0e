#pragma once

#include <filesystem>
#include <string>

#include "simulation/checkpoint/tape.hpp"

namespace tdbd::simulation {

/// What a checkpoint's file holds: a NetCDF file (CDF-5) with the columns of the tape and the case,
/// under a seal (core/seal.hpp).
struct CheckpointFile {
  std::string version;    ///< of tdbd
  std::string case_hash;  ///< Case::hash
  std::string case_text;  ///< Case::resolved
  Tape tape;
};

/// Writes `path.partial`, forces it to the disk and renames it. Throws RunError; then nothing of it
/// is left.
void write_checkpoint_file(const std::filesystem::path& path, const CheckpointFile& file);

/// Throws RunError if the file is not one of these, is torn or was changed.
CheckpointFile read_checkpoint_file(const std::filesystem::path& path);

}  // namespace tdbd::simulation
