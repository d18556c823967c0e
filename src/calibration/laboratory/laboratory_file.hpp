#pragma once

#include <filesystem>
#include <functional>

#include "calibration/laboratory/laboratory.hpp"
#include "simulation/result/output_folder.hpp"

namespace tdbd::calibration {

/// How a laboratory's records are made.
struct LaboratoryOptions {
  std::filesystem::path file;  ///< of the records, csv
  std::filesystem::path cuts;  ///< where cut runs are kept; none: `cuts`, beside the records
  simulation::Overwrite overwrite = simulation::Overwrite::no;
  int threads = 1;                                ///< the records do not depend on it
  std::function<void(long, long)> progress = {};  ///< hears how many cut runs of how many are made
};

/// Makes or finds the cut runs and writes the records. Throws InputError where the file may not be written, RunError later.
void write_records(const LaboratoryCase& c, const LaboratoryOptions& options);

}  // namespace tdbd::calibration
