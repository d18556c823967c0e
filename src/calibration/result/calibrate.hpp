#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "calibration/case/calibration_case.hpp"
#include "calibration/cuts/cut_store.hpp"
#include "calibration/fit/fit.hpp"
#include "calibration/fit/identifiability.hpp"
#include "calibration/predict/bootstrap.hpp"
#include "calibration/predict/prediction.hpp"
#include "io/output_folder.hpp"

namespace tdbd::calibration {

/// One set of coefficients with all that is known of it.
struct FittedSet {
  std::optional<double> pressure;  ///< Pa, of separate fits; nothing: all pressures together
  Fit fit;
  Identifiability identifiability;
  Discrepancy discrepancy;
  Bootstrap replicates;
};

/// What a calibration finds.
struct Calibration {
  std::vector<FittedSet> sets;            ///< one, or one for each pressure
  std::vector<Prediction> fitted;         ///< of the records of fit_bits
  std::vector<Prediction> predictions;    ///< of those of predict_bits
  std::vector<std::string> extrapolates;  ///< why predictions leave what was fitted; empty: inside
  std::vector<std::string> warnings;
};

/// Fits, judges and predicts (thesis ch. 6). Drills nothing: the cuts are there. Throws InputError
/// where the records do not identify the unknowns, RunError where no start converges.
Calibration calibrate(const CalibrationCase& c, const CutStore& cuts);

/// How a calibration is carried out.
struct CalibrateOptions {
  std::filesystem::path folder;  ///< of the results
  std::filesystem::path cuts;    ///< where cut runs are kept; none: `cuts`, beside the results
  Overwrite overwrite = Overwrite::no;
  int threads = 1;                                ///< the results do not depend on it
  std::function<void(long, long)> progress = {};  ///< hears how many cut runs of how many are made
};

/// Makes or finds the cut runs, calibrates, and writes the result folder with its timing.json. Throws InputError before
/// anything is written there, RunError later.
Calibration calibrate_into(const CalibrationCase& c, const CalibrateOptions& options);

}  // namespace tdbd::calibration
