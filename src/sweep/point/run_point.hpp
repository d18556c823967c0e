#pragma once

#include <atomic>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "simulation/case/case.hpp"
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

/// The numbers of a summary under these dotted names ("wob_mean_n", "sections.0.mean_area_m2"); true
/// and false count as 1 and 0, null as NaN. Throws InputError that lists the names that stand for no
/// number, each with the nearest that does.
std::vector<double> figures_of(const nlohmann::ordered_json& summary,
                               const std::vector<std::string>& names);

/// All names that stand for a number, in the summary's order.
std::vector<std::string> figure_names(const nlohmann::ordered_json& summary);

/// What the classical planar model says of a case's bit at its advance per revolution, before any
/// drilling: advance_m, imbalance (of normal and cutting forces, over the weight),
/// imbalance_of_unit_law, mean_redundancy, cut_area_m2, largest_cut_area_m2, engaged_cutters. SI.
/// Throws InputError for a bit without cutters and a motion without an advance.
nlohmann::ordered_json planar_summary(const simulation::Case& c, double normal_ratio);

}  // namespace tdbd::sweep
