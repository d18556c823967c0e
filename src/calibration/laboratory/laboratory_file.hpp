#pragma once

#include <filesystem>
#include <functional>

#include "calibration/laboratory/laboratory.hpp"
#include "io/output_folder.hpp"

namespace tdbd::calibration {

/// Options for the records of a laboratory.
struct LaboratoryOptions {
  std::filesystem::path file;  ///< output file, csv
  std::filesystem::path cuts;  ///< folder of cut runs; default: `cuts` next to the records
  Overwrite overwrite = Overwrite::no;
  int threads = 1;                                ///< has no effect on the records
  std::function<void(long, long)> progress = {};  ///< called with the number of computed cut runs
                                                  ///< and the total
};

/// Computes or finds the cut runs and writes the records. Throws InputError if the file must not be
/// written, RunError later.
void write_records(const LaboratoryCase& c, const LaboratoryOptions& options);

}  // namespace tdbd::calibration
