#pragma once

#include <filesystem>
#include <optional>

#include "calibration/cuts/cut_run.hpp"

namespace tdbd::calibration {

/// Writes a cut run as NetCDF: one row per part of the bit that touches rock, all columns with
/// units. The file is written completely or not at all, and sealed (io/whole_file.hpp). `names` are
/// those of the bit's parts. Throws RunError.
void write_cut_run(const std::filesystem::path& file, const CutRun& run,
                   const std::vector<std::string>& names);

/// Reads a cut run, bitwise as it was written. Returns nothing if the file does not exist or is
/// incomplete, if another commit wrote it, or if the program was built after it.
std::optional<CutRun> read_cut_run(const std::filesystem::path& file);

}  // namespace tdbd::calibration
