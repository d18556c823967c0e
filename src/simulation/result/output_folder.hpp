#pragma once

#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace tdbd::simulation {

/// Whether results may take the place of older ones.
enum class Overwrite { no, force };

/// Whether a result has pictures of its steps in a folder `frames`.
enum class HasFrames { yes, no };

/// A result folder, ready to be written to.
struct OutputFolder {
  std::filesystem::path path;

  std::filesystem::path summary() const { return path / "summary.json"; }
  std::filesystem::path timing() const { return path / "timing.json"; }
  std::filesystem::path history() const { return path / "history.nc"; }
  std::filesystem::path checkpoint() const { return path / "checkpoint.nc"; }
  std::filesystem::path new_checkpoint() const { return path / "checkpoint-new.nc"; }
  std::filesystem::path previous_checkpoint() const { return path / "checkpoint-previous.nc"; }
  std::filesystem::path rows() const { return path / "history.rows"; }
  std::filesystem::path failure() const { return path / "failure.txt"; }
  std::filesystem::path frames() const { return path / "frames"; }

  /// frames/NAME-000123.vtp
  std::filesystem::path frame(const std::string& name, long number) const;
};

/// First line of the resolved case in a result folder: it distinguishes that folder's
/// case.toml from one that a user wrote.
inline constexpr const char* resolved_head =
    "# Resolved by tdbd: every default written out, in SI.";

/// Makes `path`, and its `frames` when it has some, with all parents. With `force`, results of an
/// older run go (files of other names stay), so that no frame of it is taken for one of this run.
/// Throws InputError, and changes nothing, when the folder is not empty and `overwrite` is no, when
/// it or its `frames` is a file, when it cannot be written to, or when a file to be replaced is one
/// of `inputs` or a case.toml that a user wrote.
OutputFolder prepare(const std::filesystem::path& path, Overwrite overwrite,
                     const std::vector<std::string>& inputs = {},
                     HasFrames frames = HasFrames::yes);

/// Writes what can still be written after a failure; a second failure (the disk is full) leaves the
/// rest unwritten, since the first one is the one to report.
template <class Write>
void ignore_failure(Write write) {
  try {
    write();
  } catch (const std::exception&) {
  }
}

}  // namespace tdbd::simulation
