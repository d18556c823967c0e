#pragma once

#include <filesystem>

namespace tdbd {

/// Appends a hash of all bytes of the file. NetCDF does not look beyond its own data. Throws
/// RunError.
void seal_file(const std::filesystem::path& path);

/// Throws RunError unless the file ends with the hash of what stands before it: it was not sealed,
/// is torn, or was changed. NetCDF trusts what it reads (of a header with one wrong byte it asks
/// for a terabyte) and sees sealed files only.
void require_seal(const std::filesystem::path& path);

}  // namespace tdbd
