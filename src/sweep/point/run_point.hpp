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

/// Whether a point succeeded.
enum class PointStatus { done, failed };

/// The result of a point.
struct PointOutcome {
  PointStatus status = PointStatus::done;
  std::string case_hash;        ///< empty if the case could not be read
  std::string message;          ///< why the point failed
  std::vector<double> figures;  ///< those that the design lists; NaN if the point failed
  bool lacks_figures = false;   ///< the point failed because its summary lacks a listed figure
};

/// What a thread needs at each of its points.
struct PointSurroundings {
  std::filesystem::path cuts;  ///< folder in which a calibration keeps its cut runs
  const std::atomic<bool>* interrupted;
  Starts& starts;                    ///< shared by all threads
  rock::CuttingBit reused_bit = {};  ///< memory of the last point, to be reused
};

/// Runs the design's command on its case with these overrides, in memory. The figures are bitwise
/// identical to those of the summary that the command would write. The point fails if its case is
/// wrong, its run fails or its summary lacks a figure (`lacks_figures`). An interruption throws
/// Interrupted. Several threads may call this at once; calibrations take turns.
struct Interrupted {};
PointOutcome run_point(const Design& d, const std::vector<std::string>& overrides,
                       PointSurroundings& around);

/// Returns the files that a point reads: case, bit, tables. Throws InputError if its case is wrong.
std::vector<std::string> files_of(const Design& d, const std::vector<std::string>& overrides);

/// Returns the names of all numbers in the summary of a point, which a design may list as figures.
/// Throws whatever the command throws.
std::vector<std::string> figures_on_offer(const Design& d,
                                          const std::vector<std::string>& overrides,
                                          const std::filesystem::path& cuts);

/// Returns the numbers of a summary with these dotted names ("wob_mean_n",
/// "sections.0.mean_area_m2"). True and false count as 1 and 0, null as NaN. Throws InputError that
/// lists the names without a number, each with the nearest name that has one.
std::vector<double> figures_of(const nlohmann::ordered_json& summary,
                               const std::vector<std::string>& names);

/// Returns the names of all numbers, in the order of the summary.
std::vector<std::string> figure_names(const nlohmann::ordered_json& summary);

/// Evaluates the classical planar model for a case's bit at its advance per revolution, without
/// drilling: advance_m, imbalance (of normal and cutting forces, relative to the weight),
/// imbalance_of_unit_law, mean_redundancy, cut_area_m2, largest_cut_area_m2, engaged_cutters. SI.
/// Throws InputError for a bit without cutters or a motion without an advance.
nlohmann::ordered_json planar_summary(const simulation::Case& c, double normal_ratio);

}  // namespace tdbd::sweep
