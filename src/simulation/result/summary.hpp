#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "simulation/case/case_warning.hpp"
#include "simulation/case/studied_convergence.hpp"
#include "simulation/result/figures.hpp"
#include "simulation/step/cone_motion.hpp"
#include "simulation/step/force_figures.hpp"
#include "simulation/step/measure.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// Whether a run reached its end.
enum class RunStatus { completed, interrupted };

/// A part and what it removed, in the order of the bit's parts.
struct PartVolumes {
  std::string name;
  double removed = 0.0;               ///< m3, since the start
  std::vector<double> by_revolution;  ///< m3, one for each revolution begun
};

/// The figures of a run: what `summary.json` holds. SI. Depends on the case alone: no wall-clock
/// time and no number of threads.
struct RunSummary {
  std::string command;  ///< "run", "rotate"
  std::string title;    ///< of the case, for figures
  RunStatus status = RunStatus::completed;
  std::string case_hash;
  std::uint64_t seed = 0;
  std::vector<std::string> warnings;      ///< without_place, those found at the end last
  std::vector<CaseWarning> found_at_end;  ///< the same with their places, for a terminal
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
  std::optional<LoadFigures> loads;             ///< none: the run had no forces
  std::vector<NumericalUncertainty> numerical;  ///< by each study of the case
  Diagnosis diagnosis;                          ///< with forces
  std::optional<DriveFigures> drive;            ///< of a bit that forces move
  std::optional<StringFigures> string;          ///< of a string on a chain
  std::vector<std::pair<std::string, double>>
      broken_out;  ///< m3, by cutter, of what its face removed; empty: no rock breaks out
  std::optional<WearFigures> wear;  ///< of a bit that wears
  long sections_refused_deep = 0;   ///< FaceStatistics
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

/// Grows when a key of a summary changes its meaning or goes away.
inline constexpr int summary_schema = 1;

/// The figures of a simulation so far.
RunSummary summary_of(const Case& c, const Simulation& s, RunStatus status);

/// Doubts that only a run shows, at `motion`: a bit body, or a part that rubs, that is deeper in rock
/// than the rock's edge length and than 1 mm; a bit that removed no rock; and, of a bit that forces
/// move, an unrealistic mean advance: more in a revolution than its narrowest cutting part is wide, so
/// that its body would have to cut, or more in one step; and stick-slip with sections as they are ahead
/// of the faces. They follow from the case and from what a checkpoint contains.
std::vector<CaseWarning> end_warnings(const Case& c, const Simulation& s);

/// What every summary starts with: schema, command, title, status, provenance.
nlohmann::ordered_json summary_head(const std::string& command, const std::string& title,
                                    RunStatus status, const std::string& case_hash,
                                    std::uint64_t seed);

/// As JSON with units in the key names, every number in digits that read back to the bit.
std::string to_json(const RunSummary& summary);
std::string to_json(const Timing& timing);

/// Timing from the seconds of single steps, in any order, and of the whole.
Timing timing_of(std::vector<double> step_seconds, double wall_seconds, int threads);

/// Largest memory that this process has held so far, bytes.
long peak_memory_bytes();

/// Wall time, s.
double seconds_since(std::chrono::steady_clock::time_point start);

/// What `failure.txt` says of a run that ended after so many steps, at the time t (s).
std::string failure_text(long steps_done, long steps, double t, const std::string& what);

}  // namespace tdbd::simulation
