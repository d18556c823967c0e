#pragma once

#include <filesystem>
#include <string>

#include "io/output_folder.hpp"
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

/// Output location of a study.
struct ConvergencePlace {
  std::filesystem::path folder;
  Overwrite overwrite = Overwrite::no;
  std::string reference;  ///< folder or file of the plan's reference: must not be overwritten
};

/// Checks the plan, claims the folder, runs the study and writes the files; writes failure.txt if a
/// level fails. Throws like check, claim and converge.
Convergence converge_into(const ConvergencePlace& place, const ConvergencePlan& plan,
                          const ConvergenceOptions& options);

}  // namespace tdbd::simulation
