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

#include "simulation/case/run_settings.hpp"
#include "simulation/result/figures.hpp"
#include "simulation/step/diagnosis.hpp"
#include "simulation/step/drive.hpp"
#include "simulation/step/loads.hpp"
#include "simulation/step/measure.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::simulation {

/// A number with its noun: "1 step", "2 steps", "0.4 revolutions". `number`: as printed.
inline std::string counted(const std::string& number, const std::string& noun) {
  return number + " " + noun + (number == "1" ? "" : "s");
}

/// Whether a run reached its end.
enum class RunStatus { completed, interrupted };

/// The volumes removed by a part, in the order of the bit's parts.
struct PartVolumes {
  std::string name;
  double removed = 0.0;               ///< m3, since the start
  std::vector<double> by_revolution;  ///< m3, one value per revolution begun
};

/// The results of a run, which are written to `summary.json`. SI. They depend on the case only, not
/// on wall-clock times or the number of threads.
struct RunSummary {
  std::string command;  ///< "run", "rotate"
  std::string title;    ///< of the case, for figures
  RunStatus status = RunStatus::completed;
  std::string case_hash;
  std::uint64_t seed = 0;
  std::vector<std::string> warnings;      ///< without places; those found at the end are last
  std::vector<CaseWarning> found_at_end;  ///< the same with their places, for a terminal
  long steps = 0;
  double revolutions = 0.0;
  double duration = 0.0;                             ///< s, simulated
  double removed_volume = 0.0;                       ///< m3
  std::vector<double> removed_volume_by_revolution;  ///< m3
  std::vector<PartVolumes> parts;
  double volume_ledger_defect = 0.0;  ///< relative
  double maintenance_volume = 0.0;    ///< m3 that maintenance of the mesh added (+) or removed (-)
  double trimmed_volume = 0.0;  ///< m3 of the hole about W's origin, removed with trimmed wall
  long rock_triangles_start = 0;
  long rock_triangles_end = 0;
  double rock_quality_min = 0.0;
  double rock_quality_1_percent = 0.0;
  double gage_radius = 0.0;                 ///< m
  std::map<std::string, long> maintenance;  ///< counts by operation
  std::vector<ConeSummary> cones;
  std::vector<FaceSummary> faces;
  std::optional<LoadStatisticsSummary> loads;  ///< empty: the run had no forces
  std::optional<double> set_weight;            ///< N, mean of the set weight on bit; see set_weight
  SteadyState steady;                          ///< if the run has forces
  std::vector<NumericalUncertainty> numerical;  ///< one for each study of the case
  Diagnosis diagnosis;                          ///< if the run has forces
  std::optional<DriveFigures> drive;            ///< if forces move the bit
  std::optional<StringSummary> string;          ///< if the string is a chain
  std::vector<std::pair<std::string, double>>
      broken_out;  ///< m3, by cutter, of what its face removed; empty: no rock breaks out
  std::optional<WearFigures> wear;  ///< if the bit wears
  long sections_refused_deep = 0;   ///< FaceStatistics
  long sections_refused_over_the_top = 0;
};

/// The results that depend on the machine, which are written to `timing.json`.
struct Timing {
  double seconds_per_step_median = 0.0;
  double wall_seconds = 0.0;
  long peak_memory_bytes = 0;
  int threads = 1;
  double seconds_per_step_mean = 0.0;
};

/// Increased when the meaning of a summary's key changes or a key is removed.
inline constexpr int summary_schema = 2;

/// Computes the results of a simulation so far.
RunSummary summary_of(const Case& c, const Simulation& s, RunStatus status);

/// Returns the mean of the weight on bit that the case sets, N, between two times (s) of the run.
/// Nothing if the case sets a rate, or if the weight is that at the surface of a chain.
std::optional<double> set_weight(const Case& c, double from, double to);

/// Returns warnings that only a run can detect, at `motion`: a bit body or a rubbing part that is
/// deeper in rock than the rock's edge length and than 1 mm; a bit that removed no rock; an
/// unrealistic mean advance of a bit that forces move (in one revolution or in one step more than
/// the width of its narrowest cutting part, so that its body would have to cut); stick-slip with
/// sections that are not extrapolated to the faces; a mean weight on bit that differs from the set
/// one by more than 1 % and than its confidence interval; means that drift (steady_state). They
/// depend on the case and the contents of a checkpoint only.
std::vector<CaseWarning> end_warnings(const Case& c, const Simulation& s);

/// Returns the beginning of every summary: schema, command, title, status, provenance.
nlohmann::ordered_json summary_head(const std::string& command, const std::string& title,
                                    RunStatus status, const std::string& case_hash,
                                    std::uint64_t seed);

/// Returns JSON with units in the names of keys. Numbers have as many digits as are required to
/// read them back exactly.
std::string to_json(const RunSummary& summary);
std::string to_json(const Timing& timing);

/// Computes timing from the run times of single steps, in any order, and of the whole run.
Timing timing_of(std::vector<double> step_seconds, double wall_seconds, int threads);

/// Returns the largest memory of this process so far, in bytes.
long peak_memory_bytes();

/// Returns the wall time since `start`, s.
double seconds_since(std::chrono::steady_clock::time_point start);

/// Returns the text of `failure.txt` for a run that failed after `steps_done` steps, at the time t
/// (s).
std::string failure_text(long steps_done, long steps, double t, const std::string& what);

// The answer of a run for a reader: what `tdbd run` prints.

/// Units of printed answers.
enum class AnswerUnits {
  metric,  ///< kN, kN m, m/h, mm, MPa, cm3
  field,   ///< lbf, ft lbf, ft/h, in, psi, in3
};

/// A value and, if it is known and not negligible, the half-width of its interval: "30.010 +-
/// 0.011", "139.4". The half-width has two significant digits and the value as many decimals, at
/// most six significant digits; without a half-width it has four.
std::string with_half_width(double value, std::optional<double> half_width = {});

/// Returns "a volume" of m3 in these units: "123.4 cm3".
std::string volume_text(double volume, AnswerUnits units);

/// Returns the answer of a run, a line for each: weight on bit and the set one, torque, rate,
/// specific energy, imbalance, diagnosis. Half-widths are those of 95 % confidence intervals of the
/// means over time (SamplingUncertainty). A run without forces or without means has one line, which
/// states why.
std::vector<std::string> answer_lines(const RunSummary& summary, AnswerUnits units);

}  // namespace tdbd::simulation
