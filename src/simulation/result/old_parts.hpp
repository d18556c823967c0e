#pragma once

#include <filesystem>
#include <vector>

namespace tdbd::simulation {

/// The meshes of parts that the bit in this folder was exported with, as far as they are there: those that its bit.toml
/// names, and, of a roller cone bit, whose bit.toml names none, the parts of its solids.toml in every format in which all of
/// them are there. Whatever else lies in parts/ is somebody else's. Nothing where these files are not TDBD's any more.
std::vector<std::filesystem::path> exported_parts(const std::filesystem::path& folder);

/// Removes the files, and the folders below parts/ that this empties.
void remove_parts(const std::filesystem::path& folder,
                  const std::vector<std::filesystem::path>& files);

}  // namespace tdbd::simulation
