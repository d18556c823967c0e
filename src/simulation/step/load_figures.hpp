#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "simulation/step/diagnosis.hpp"
#include "simulation/step/loads.hpp"
#include "simulation/step/measure.hpp"

namespace tdbd::simulation {

/// Mean and standard deviation over steps.
struct MeanAndDeviation {
  double mean = 0.0, deviation = 0.0;
};

inline constexpr double sampling_coverage = 0.95;

/// Statistical uncertainty of the means over the recorded steps, relative to an infinitely long
/// run: half-widths of 95 % confidence intervals, from the means of eight equal batches. Empty if
/// there are fewer steps than batches. Errors of mesh and time step are not included (`tdbd
/// converge`).
struct SamplingUncertainty {
  std::optional<double> wob, tob, rop, rotary_speed;  ///< N, N m, m/s, rad/s
};

/// Statistics of one part of the bit.
struct PartLoadFigures {
  std::string name;
  MeanAndDeviation normal, tangential;  ///< N
  double power = 0.0;                   ///< W, mean
  double removed = 0.0;                 ///< m3, by the whole cutter of the part
  double specific_energy = 0.0;         ///< Pa: energy per volume; 0 without volume
};

/// Statistics of the forces on the bit over the recorded steps. SI units.
struct LoadStatisticsSummary {
  long steps = 0;                      ///< recorded steps; if 0, the other members are unknown
  double from = 0.0, to = 0.0;         ///< s, time range of the recorded steps
  MeanAndDeviation wob, tob;           ///< N, N m
  MeanAndDeviation rop, rotary_speed;  ///< m/s, rad/s
  SamplingUncertainty uncertainty;
  double aggressiveness = 0.0;         ///< 3 T / (D W); in oilfield units 36 T / (D W)
  double specific_energy = 0.0;        ///< Pa, W/A + w T/(A v), A the gage circle
  double imbalance = 0.0;              ///< mean lateral force in the bit's frame over WOB
  double imbalance_azimuth = 0.0;      ///< rad, azimuth of that force in the frame of the bit
  double power = 0.0;                  ///< W, mean, spent on the rock
  std::vector<PartLoadFigures> parts;  ///< parts with a force
};

/// Converts the statistics to the JSON of `summary.json`: wob_mean_n, tob_mean_n_m,
/// rop_mean_m_per_s and others at top level, parts under "forces". Null if no step was recorded.
nlohmann::ordered_json to_json(const LoadStatisticsSummary& figures);

/// Sums of forces over the recorded steps.
struct LoadStatistics {
  RunningVariance wob, tob;                         ///< N, N m
  RunningVariance rop, rotary_speed;                ///< m/s, rad/s
  Vec3 lateral_B = Vec3::Zero();                    ///< N, mean force on the bit in its frame
  double energy = 0.0;                              ///< J, dissipated in the rock
  double removed = 0.0;                             ///< m3
  double time = 0.0;                                ///< s
  std::vector<RunningVariance> normal, tangential;  ///< N, per part
  std::vector<double> part_energy, part_removed;    ///< J, m3, per part

  template <class Archive>
  void serialize(Archive& a) {
    a(wob, tob, rop, rotary_speed, lateral_B, energy, removed, time, normal, tangential,
      part_energy, part_removed);
  }
};

/// Progress of the bit in a step. In free motion these are displacements divided by the step, so
/// that their means are displacements over time; in prescribed motion they are velocities.
struct StepRates {
  double penetration = 0.0;  ///< m/s relative to the rock along z
  double rotary = 0.0;       ///< rad/s about the axis of the bit
};
StepRates rates_of(const Move& move);
StepRates rates_of(const BitVelocity& velocity, const Pose& X_WB);

/// Forces of one step, for the statistics and the history.
struct LoadedStep {
  const BitLoads& loads;
  const BitVelocity& velocity;
  const Pose& X_WB;
  const std::vector<double>& removed_by_part;  ///< m3
  double dt = 0.0;                             ///< s
  StepRates rates;
};

void add(const LoadedStep& step, LoadStatistics& statistics);
void add(const LoadedStep& step, Trace& trace);

MeanAndDeviation figures_of(const RunningVariance& spread);

LoadStatisticsSummary figures_of(const bit::Bit& bit, const LoadStatistics& statistics, double end);

/// Half-width of the confidence interval (sampling_coverage) of the mean of `samples`, from
/// Student's t distribution of the means of eight consecutive batches of equal length. Initial
/// samples that do not fill a batch are omitted. Nothing for fewer than eight samples. (Schmeiser,
/// Oper. Res. 30:556, 1982.)
std::optional<double> batch_uncertainty(const std::vector<double>& samples);
SamplingUncertainty sampling_of(const Trace& trace);

}  // namespace tdbd::simulation
