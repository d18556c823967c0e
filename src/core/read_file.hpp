#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tdbd {

/// Throws InputError "PATH: found F, expected E" unless `path` is a regular file (or a link to one) that can be opened.
/// Pipes and devices are refused unopened: they may have no end. `expected` says what the file should be: "a TOML file".
void demand_file(const std::filesystem::path& path, std::string_view expected);

/// All bytes of a file. Throws InputError as demand_file does, and when reading fails.
std::string read_file(const std::filesystem::path& path, std::string_view expected);

}  // namespace tdbd
