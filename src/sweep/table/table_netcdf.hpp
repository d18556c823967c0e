#pragma once

#include <filesystem>

#include "sweep/table/table.hpp"

namespace tdbd::sweep {

/// The NetCDF half of write_table. The file appears whole or not at all. Throws RunError.
void write_netcdf(const std::filesystem::path& file, const Table& t);

}  // namespace tdbd::sweep
