#pragma once

#include <filesystem>
#include <string>

#include "simulation/study/convergence.hpp"

namespace tdbd::simulation {

/// The table of errors by level and variable, and the observed orders in words, for a terminal.
std::string table_text(const Convergence& c);

/// As JSON: levels, and for every variable scale, errors, local orders, verdict and order (null
/// where there is none). Every number in digits that read back to the bit.
std::string to_json(const Convergence& c);

/// One line for each error: size, steps, and a column for each variable, absolute.
std::string to_csv(const Convergence& c);

/// Writes convergence.json and convergence.csv. Throws RunError.
void write_convergence(const std::filesystem::path& folder, const Convergence& c);

}  // namespace tdbd::simulation
