#pragma once

#include <filesystem>
#include <functional>

#include "calibration/result/calibrate.hpp"
#include "simulation/result/output_folder.hpp"

namespace tdbd::calibration {

/// How a calibration is carried out.
struct CalibrateOptions {
  std::filesystem::path folder;  ///< of the results
  std::filesystem::path cuts;    ///< where cut runs are kept; none: `cuts`, beside the results
  simulation::Overwrite overwrite = simulation::Overwrite::no;
  int threads = 1;                                ///< the results do not depend on it
  std::function<void(long, long)> progress = {};  ///< hears how many cut runs of how many are made
};

/// Makes or finds the cut runs, calibrates, and writes the result folder with its timing.json. Throws InputError before
/// anything is written there, RunError later.
Calibration calibrate_into(const CalibrationCase& c, const CalibrateOptions& options);

}  // namespace tdbd::calibration
