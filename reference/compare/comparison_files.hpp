#pragma once

#include <filesystem>

#include "reference/compare/comparison.hpp"
#include "simulation/result/output_folder.hpp"

namespace tdbd::reference {

/// Throws InputError when the folder is a file, or not empty and `overwrite` is no: before the work.
void check_folder(const std::filesystem::path& folder, simulation::Overwrite overwrite);

/// Writes comparison.csv, parts.csv, comparison.nc, case.toml, timing.json and, last,
/// comparison.json. All but timing.json are the same bytes for the same case. Throws RunError.
void write_comparison(const std::filesystem::path& folder, const CompareCase& c,
                      const Comparison& all);

/// comparison.csv: a row for each model and quantity, SI: its value, or the reason for the blank.
std::string comparison_csv(const Comparison& all);

/// parts.csv: a row for each number about a cutter, a tooth, a row of teeth or a cone, SI.
std::string parts_csv(const Comparison& all);

/// comparison.json: the case, the models, what they say of the bit and of its parts, what they cannot say and why.
std::string comparison_json(const CompareCase& c, const Comparison& all);

/// timing.json: CPU time of each model, which depends on the machine.
std::string timing_json(const Comparison& all);

/// comparison.nc: quantities over models, series of loads, and the bottom on a circle.
void write_comparison_netcdf(const std::filesystem::path& file, const Comparison& all);

/// The table for a terminal.
std::string comparison_table(const Comparison& all);

}  // namespace tdbd::reference
