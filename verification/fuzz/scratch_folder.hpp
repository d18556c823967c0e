#pragma once

#include <string>
#include <string_view>

namespace tdbd::fuzz {

/// The path of `name` in a folder of this process, in memory where the machine has such a folder. It begins as a copy of
/// verification/fuzz/files, which the texts of the corpus name, and goes when the process ends.
std::string scratch_path(std::string_view name);

/// Writes that file and returns its path. For readers that take paths only.
std::string scratch_file(std::string_view name, std::string_view bytes);

}  // namespace tdbd::fuzz
