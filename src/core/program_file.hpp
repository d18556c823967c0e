#pragma once

#include <filesystem>

namespace tdbd {

/// The file that this code was loaded from: the program, or the shared library that it is part of.
std::filesystem::path program_file();

}  // namespace tdbd
