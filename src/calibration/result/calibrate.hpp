#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "calibration/case/calibration_case.hpp"
#include "calibration/cuts/cut_store.hpp"
#include "calibration/fit/fit.hpp"
#include "calibration/fit/identifiability.hpp"
#include "calibration/predict/prediction.hpp"
#include "io/output_folder.hpp"

namespace tdbd::calibration {

/// One set of coefficients with its statistics.
struct FittedSet {
  std::optional<double> pressure;  ///< Pa, of separate fits; empty: all pressures together
  Fit fit;
  Identifiability identifiability;
  Discrepancy discrepancy;
  Bootstrap replicates;
};

/// The result of a calibration.
struct Calibration {
  std::vector<FittedSet> sets;            ///< one, or one for each pressure
  std::vector<Prediction> fitted;         ///< of the records of fit_bits
  std::vector<Prediction> predictions;    ///< of the records of predict_bits
  std::vector<std::string> extrapolates;  ///< why predictions extrapolate; empty: they do not
  std::vector<std::string> warnings;
};

/// Fits, validates and predicts (thesis ch. 6). Does not drill; `cuts` contains the cut runs.
/// Throws InputError if the records do not identify the unknowns, RunError if the fit converges
/// from no start.
Calibration calibrate(const CalibrationCase& c, const CutStore& cuts);

/// Options of a calibration.
struct CalibrateOptions {
  std::filesystem::path folder;  ///< for the results
  std::filesystem::path cuts;    ///< for cut runs; empty: the folder `cuts` beside the results
  Overwrite overwrite = Overwrite::no;
  int threads = 1;                                ///< the results do not depend on it
  std::function<void(long, long)> progress = {};  ///< cut runs completed and in all
};

/// Reads or computes the cut runs, calibrates, and writes the result folder with its timing.json.
/// Throws InputError before anything is written there, RunError later.
Calibration calibrate_into(const CalibrationCase& c, const CalibrateOptions& options);

}  // namespace tdbd::calibration
