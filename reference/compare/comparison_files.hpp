#pragma once

#include <filesystem>

#include "io/output_folder.hpp"
#include "reference/compare/comparison.hpp"

namespace tdbd::reference {

/// Throws InputError if the folder is a file, or is not empty and `overwrite` is no. Called before
/// the models run.
void check_folder(const std::filesystem::path& folder, Overwrite overwrite);

/// Writes comparison.csv, parts.csv, comparison.nc, case.toml, timing.json and, last,
/// comparison.json. All except timing.json are bitwise identical for the same case. Throws
/// RunError.
void write_comparison(const std::filesystem::path& folder, const CompareCase& c,
                      const Comparison& all);

/// comparison.csv: one row per model and quantity, SI: its value, or the reason why there is none.
std::string comparison_csv(const Comparison& all);

/// parts.csv: one row per value of a cutter, a tooth, a row of teeth or a cone, SI.
std::string parts_csv(const Comparison& all);

/// comparison.json: the case, the models, their results for the bit and its parts, and the
/// quantities that they cannot compute with the reasons.
std::string comparison_json(const CompareCase& c, const Comparison& all);

/// timing.json: CPU time of each model, which depends on the machine.
std::string timing_json(const Comparison& all);

/// comparison.nc: quantities over models, time series of loads, and the bottom on a circle.
void write_comparison_netcdf(const std::filesystem::path& file, const Comparison& all);

/// The table for a terminal.
std::string comparison_table(const Comparison& all);

}  // namespace tdbd::reference
