#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calibration/result/calibrate.hpp"
#include "io/output_folder.hpp"

namespace tdbd::calibration {

/// Throws FolderError when the folder is not empty and `overwrite` is no, or is a file: before the work.
void check_folder(const std::filesystem::path& folder, Overwrite overwrite);

/// Makes the result folder and holds it for one command. With `force`, files of an older calibration go; others stay.
/// Throws FolderError, and changes nothing, when another command holds it, when it is not empty and `overwrite` is no,
/// or when a file to be replaced is one of `inputs` or a case.toml that a user wrote.
OutputFolder prepare_folder(const std::filesystem::path& folder, Overwrite overwrite,
                            const std::vector<std::string>& inputs);

/// Writes calibration.json, law.toml (one for each pressure of separate fits), residuals.csv,
/// predictions.csv, case.toml and copies of the cut runs; calibration.json last. Throws RunError.
void write_calibration(const std::filesystem::path& folder, const CalibrationCase& c,
                       const CutStore& cuts, const Calibration& found);

/// calibration.json.
std::string to_json(const CalibrationCase& c, const Calibration& found);

/// law.toml: a table [forces] for a case, all coefficients in SI.
std::string law_toml(const forces::Law& law);

/// predictions.csv or residuals.csv: the records' columns in SI, then mean, interval and measured
/// load of each kind.
std::string predictions_csv(ToolKind kind, const std::vector<Prediction>& predictions);

}  // namespace tdbd::calibration
