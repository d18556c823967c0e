#pragma once

#include <filesystem>

namespace tdbd {

/// Appends a hash of all bytes of the file. NetCDF ignores bytes after its own data. Throws
/// RunError.
void seal_file(const std::filesystem::path& path);

/// Checks that the file ends with the hash of the bytes before it. Throws RunError if it was not
/// sealed, is truncated, or was changed. NetCDF does not validate what it reads (one wrong byte in
/// a header made it allocate a terabyte), so it must only open sealed files.
void require_seal(const std::filesystem::path& path);

}  // namespace tdbd
