#pragma once

#include <filesystem>
#include <optional>

#include "calibration/cuts/cut_run.hpp"

namespace tdbd::calibration {

/// Writes a cut run as NetCDF: a row for each part of the bit that touches rock, all columns with
/// units, whole or not at all, under a seal (core/seal.hpp). `names` are those of the bit's parts. Throws RunError.
void write_cut_run(const std::filesystem::path& file, const CutRun& run,
                   const std::vector<std::string>& names);

/// Reads it back to the bit; nothing when there is no such file or not a whole one, when another
/// commit wrote it, or when the program was built after it.
std::optional<CutRun> read_cut_run(const std::filesystem::path& file);

}  // namespace tdbd::calibration
