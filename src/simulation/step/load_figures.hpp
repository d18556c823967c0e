#pragma once

#include <optional>
#include <vector>

#include "simulation/step/diagnosis.hpp"
#include "simulation/step/force_figures.hpp"
#include "simulation/step/loads.hpp"
#include "simulation/step/spread.hpp"

namespace tdbd::simulation {

/// Sums of forces over the recorded steps.
struct LoadStatistics {
  Spread wob, tob;                                ///< N, N m
  Spread rop, rotary_speed;                       ///< m/s, rad/s
  Vec3 lateral_B = Vec3::Zero();                  ///< N, mean force on the bit in its frame
  double energy = 0.0;                            ///< J, dissipated in the rock
  double removed = 0.0;                           ///< m3
  double time = 0.0;                              ///< s
  std::vector<Spread> normal, tangential;         ///< N, per part
  std::vector<double> part_energy, part_removed;  ///< J, m3, per part

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

MeanAndDeviation figures_of(const Spread& spread);

LoadFigures figures_of(const bit::Bit& bit, const LoadStatistics& statistics, double end);

/// Half-width of the confidence interval (sampling_coverage) of the mean of `samples`, from
/// Student's t distribution of the means of eight consecutive batches of equal length. Initial
/// samples that do not fill a batch are omitted. Nothing for fewer than eight samples. (Schmeiser,
/// Oper. Res. 30:556, 1982.)
std::optional<double> batch_uncertainty(const std::vector<double>& samples);
SamplingUncertainty sampling_of(const Trace& trace);

}  // namespace tdbd::simulation
