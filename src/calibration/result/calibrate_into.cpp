#include "calibration/result/calibrate_into.hpp"

#include <fmt/format.h>

#include <chrono>

#include "calibration/result/calibration_files.hpp"
#include "core/parallel.hpp"
#include "core/whole_file.hpp"
#include "simulation/result/summary.hpp"

namespace tdbd::calibration {
namespace {

/// Where cut runs are kept: beside the result, so that the next calibration finds them.
std::filesystem::path cuts_folder(const CalibrateOptions& o) {
  if (!o.cuts.empty()) return o.cuts;
  return std::filesystem::absolute(o.folder).lexically_normal().parent_path() / "cuts";
}

void write_timing(const std::filesystem::path& folder, const CutStore& cuts, double cut_seconds,
                  double fit_seconds) {
  write_text(
      folder / "timing.json",
      fmt::format("{{\"cut_runs_made\": {}, \"cut_runs_found\": {}, \"cut_seconds\": {:.4f}, "
                  "\"fit_seconds\": {:.4f}}}\n",
                  cuts.made, cuts.found, cut_seconds, fit_seconds));
}

}  // namespace

Calibration calibrate_into(const CalibrationCase& c, const CalibrateOptions& o) {
  const auto started = std::chrono::steady_clock::now();
  const ThreadLimit limit(o.threads);
  check_folder(o.folder, o.overwrite);
  const CutStore cuts = find_cuts(c, cuts_folder(o), o.progress);
  const double cut_seconds = simulation::seconds_since(started);
  Calibration found = calibrate(c, cuts);
  const double fit_seconds = simulation::seconds_since(started) - cut_seconds;
  const auto held = prepare_folder(o.folder, o.overwrite, c.files);
  write_timing(o.folder, cuts, cut_seconds, fit_seconds);
  write_calibration(o.folder, c, cuts, found);
  return found;
}

}  // namespace tdbd::calibration
