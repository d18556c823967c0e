#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "calibration/case/calibration_case.hpp"
#include "calibration/cuts/cut_store.hpp"
#include "calibration/fit/fit.hpp"
#include "calibration/fit/quality.hpp"
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
  FitQuality quality;
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

/// Throws FolderError if the folder is a file, or is not empty although `overwrite` is no. To be
/// called before cut runs are computed.
void check_folder(const std::filesystem::path& folder, Overwrite overwrite);

/// Creates the result folder and locks it for one command. If `overwrite` is force, files of an
/// older calibration are removed; other files stay. Throws FolderError without changing anything if
/// another command has locked the folder, if it is not empty although `overwrite` is no, or if a
/// file to be replaced is one of `inputs` or a case.toml that a user wrote.
OutputFolder prepare_folder(const std::filesystem::path& folder, Overwrite overwrite,
                            const std::vector<std::string>& inputs);

/// Writes calibration.json, law.toml (one for each pressure of separate fits), residuals.csv,
/// predictions.csv, case.toml and copies of the cut runs. calibration.json is written last. Throws
/// RunError.
void write_calibration(const std::filesystem::path& folder, const CalibrationCase& c,
                       const CutStore& cuts, const Calibration& found);

/// Returns the text of calibration.json.
std::string to_json(const CalibrationCase& c, const Calibration& found);

/// Returns the text of law.toml: a table [forces] for a case, with all coefficients in SI.
std::string law_toml(const forces::Law& law);

/// Returns the text of predictions.csv or residuals.csv: the columns of the records in SI, then
/// mean, interval and measured value of each kind of load.
std::string predictions_csv(ToolKind kind, const std::vector<Prediction>& predictions);

}  // namespace tdbd::calibration
