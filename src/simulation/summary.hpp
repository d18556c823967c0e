#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "simulation/drive_figures.hpp"
#include "simulation/force_figures.hpp"

namespace tdbd::simulation {

/// Whether a run reached its end.
enum class RunStatus { completed, interrupted };

/// A part and what it removed, in the order of the bit's parts.
struct PartVolumes {
  std::string name;
  double removed = 0.0;               ///< m3, since the start
  std::vector<double> by_revolution;  ///< m3, one for each revolution begun
};

/// How a cone turned: its speed over the bit's, rolling positive.
struct ConeFigures {
  std::string name;
  double mean_speed_ratio = 0.0;  ///< turn of the cone over turn of the bit, whole run
  double min_speed_ratio = 0.0;   ///< of single steps
  double max_speed_ratio = 0.0;
  double std_speed_ratio = 0.0;
  double rolling_ratio_gage_row = 0.0;  ///< at which the gage row would roll without slip
  double net_slip_gage_row = 0.0;       ///< 1 - mean over rolling: positive when the cone lags
};

/// One cutter's section beside the volume that it removed, over a revolution.
struct FaceFigures {
  std::string name;                    ///< "cutter-12"
  double mean_area = 0.0;              ///< m2
  double mean_swept_by_section = 0.0;  ///< m3 in a step
  double mean_removed = 0.0;           ///< m3 in a step
  double rms_swept_by_section = 0.0;   ///< over the mean
  double rms_removed = 0.0;            ///< over the mean
};

/// The figures of a run: what `summary.json` holds. SI. Depends on the case alone: no wall-clock
/// time and no number of threads.
struct RunSummary {
  std::string command;  ///< "run", "rotate"
  std::string title;    ///< of the case, for figures
  RunStatus status = RunStatus::completed;
  std::string case_hash;
  std::uint64_t seed = 0;
  long steps = 0;
  double revolutions = 0.0;
  double duration = 0.0;                             ///< s, simulated
  double removed_volume = 0.0;                       ///< m3
  std::vector<double> removed_volume_by_revolution;  ///< m3
  std::vector<PartVolumes> parts;
  double volume_ledger_defect = 0.0;  ///< relative
  double maintenance_volume = 0.0;    ///< m3 that maintenance of the mesh added (+) or took (-)
  double trimmed_volume = 0.0;  ///< m3 of the hole about W's origin that went with trimmed wall
  long rock_triangles_start = 0;
  long rock_triangles_end = 0;
  double rock_quality_min = 0.0;
  double rock_quality_1_percent = 0.0;
  double gage_radius = 0.0;                 ///< m
  std::map<std::string, long> maintenance;  ///< operation: how often
  std::vector<ConeFigures> cones;
  std::vector<FaceFigures> faces;
  std::optional<LoadFigures> loads;   ///< none: the run asked for no forces
  Diagnosis diagnosis;                ///< with forces
  std::optional<DriveFigures> drive;  ///< of a bit that forces move
  long sections_refused_deep = 0;     ///< Measures
  long sections_refused_over_the_top = 0;
};

/// What depends on the machine: what `timing.json` holds.
struct Timing {
  double seconds_per_step_median = 0.0;
  double wall_seconds = 0.0;
  long peak_memory_bytes = 0;
  int threads = 1;
  double seconds_per_step_mean = 0.0;
};

/// As JSON with units in the key names, every number in digits that read back to the bit.
std::string to_json(const RunSummary& summary);
std::string to_json(const Timing& timing);

/// Writes a text file, whole or not at all. Throws RunError.
void write_text(const std::filesystem::path& path, const std::string& text);

/// Timing from the seconds of single steps, in any order, and of the whole.
Timing timing_of(std::vector<double> step_seconds, double wall_seconds, int threads);

/// Largest memory that this process has held so far, bytes.
long peak_memory_bytes();

}  // namespace tdbd::simulation
