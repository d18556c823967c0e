#pragma once

#include <filesystem>
#include <string>

#include "simulation/study/convergence.hpp"

namespace tdbd::simulation {

/// Table of errors by level and variable with the observed orders, as text for a terminal.
std::string table_text(const Convergence& c);

/// JSON with levels, and for every variable scale, errors, local orders, verdict and order (null if
/// there is none). Numbers have enough digits to be restored bitwise.
std::string to_json(const Convergence& c);

/// CSV with one line per error: size, steps, and the absolute error of each variable.
std::string to_csv(const Convergence& c);

/// Writes convergence.json and convergence.csv. Throws RunError.
void write_convergence(const std::filesystem::path& folder, const Convergence& c);

}  // namespace tdbd::simulation
