#pragma once

#include <filesystem>

namespace tdbd {

/// The file from which this code was loaded: the program or a shared library.
std::filesystem::path program_file();

}  // namespace tdbd
