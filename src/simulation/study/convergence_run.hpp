#pragma once

#include <filesystem>
#include <string>

#include "io/output_folder.hpp"
#include "simulation/study/convergence.hpp"

namespace tdbd::simulation {

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
