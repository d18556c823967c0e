#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "sweep/design/design.hpp"
#include "sweep/point/starts.hpp"

namespace tdbd::sweep {

/// How a point ended.
enum class PointStatus { done, failed };

/// What a point came to.
struct PointOutcome {
  PointStatus status = PointStatus::done;
  std::string case_hash;        ///< empty where the case could not be read
  std::string message;          ///< why it failed
  std::vector<double> figures;  ///< those of the design; NaN where it failed
  bool lacks_figures = false;   ///< failed since the summary has no number of such a name
};

/// What a thread needs at all its points.
struct PointSurroundings {
  std::filesystem::path cuts;  ///< where a calibration keeps its cut runs
  const std::atomic<bool>* interrupted;
  Starts& starts;              ///< of all threads
  rock::CuttingBit room = {};  ///< of the last point
};

/// Runs the design's command on its case with these overrides, in memory: the figures are those of
/// the summary that the command would write, to the bit. A wrong case, a run that fails and a figure
/// that the summary lacks (`lacks_figures`) make a failed point. An interruption throws Interrupted.
/// Threads may call it at once, calibrations take turns.
struct Interrupted {};
PointOutcome run_point(const Design& d, const std::vector<std::string>& overrides,
                       PointSurroundings& around);

/// The files that a point reads: case, bit, tables. Throws InputError where its case is wrong.
std::vector<std::string> files_of(const Design& d, const std::vector<std::string>& overrides);

/// The names of all numbers in the summary of a point: those that a design may ask for. Throws what
/// the command throws.
std::vector<std::string> figures_on_offer(const Design& d,
                                          const std::vector<std::string>& overrides,
                                          const std::filesystem::path& cuts);

}  // namespace tdbd::sweep
