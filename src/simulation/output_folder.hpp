#pragma once

#include <filesystem>
#include <string>

namespace tdbd::simulation {

/// Whether results may take the place of older ones.
enum class Overwrite { no, force };

/// A result folder, ready to be written to. Names of results are those of the design.
struct OutputFolder {
  std::filesystem::path path;

  std::filesystem::path summary() const { return path / "summary.json"; }
  std::filesystem::path timing() const { return path / "timing.json"; }
  std::filesystem::path history() const { return path / "history.nc"; }
  std::filesystem::path checkpoint() const { return path / "checkpoint.nc"; }
  std::filesystem::path frames() const { return path / "frames"; }

  /// frames/NAME-000123.vtp
  std::filesystem::path frame(const std::string& name, long number) const;
};

/// Makes `path` and its `frames` with all parents. With `force`, results of an older run go (other
/// files stay), so that no frame of it is taken for one of this run. Throws InputError when the
/// folder is not empty and `overwrite` is no, when it is a file, or when it cannot be written to.
OutputFolder prepare(const std::filesystem::path& path, Overwrite overwrite);

}  // namespace tdbd::simulation
