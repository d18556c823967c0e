#pragma once

#include <filesystem>
#include <string>

#include "simulation/result/output_folder.hpp"
#include "simulation/study/convergence.hpp"

namespace tdbd::simulation {

/// Where a study's files go.
struct ConvergencePlace {
  std::filesystem::path folder;
  Overwrite overwrite = Overwrite::no;
  std::string
      reference;  ///< that the plan's was read from, folder or file: it must not be replaced
};

/// Checks the plan, takes the folder, converges and writes the files; failure.txt where a level fails. Throws like
/// check, claim and converge.
Convergence converge_into(const ConvergencePlace& place, const ConvergencePlan& plan,
                          const ConvergenceOptions& options);

}  // namespace tdbd::simulation
