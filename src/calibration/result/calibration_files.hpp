#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calibration/result/calibrate.hpp"
#include "io/output_folder.hpp"

namespace tdbd::calibration {

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
