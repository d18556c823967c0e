#pragma once

#include <optional>
#include <vector>

#include "simulation/step/diagnosis.hpp"
#include "simulation/step/force_figures.hpp"
#include "simulation/step/loads.hpp"
#include "simulation/step/spread.hpp"

namespace tdbd::simulation {

/// Sums over the steps that count, of what forces did.
struct LoadStatistics {
  Spread wob, tob;                                ///< N, N m
  Spread rop, rotary_speed;                       ///< m/s, rad/s
  Vec3 lateral_B = Vec3::Zero();                  ///< N, mean force on the bit in its frame
  double energy = 0.0;                            ///< J, spent on the rock
  double removed = 0.0;                           ///< m3
  double time = 0.0;                              ///< s
  std::vector<Spread> normal, tangential;         ///< N, per part
  std::vector<double> part_energy, part_removed;  ///< J, m3, per part
};

/// How fast the bit went on in a step. Of a bit that forces move, displacements over the step's time,
/// so that their means are displacements over time; of a prescribed motion its velocity.
struct StepRates {
  double penetration = 0.0;  ///< m/s over the rock along z
  double rotary = 0.0;       ///< rad/s about the bit's axis
};
StepRates rates_of(const Move& move);
StepRates rates_of(const BitVelocity& velocity, const Pose& X_WB);

/// One step of forces, for the sums and for the history.
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

/// Half-width of the interval of sampling_coverage about the mean of `samples`, by Student's t of the
/// means of eight consecutive batches of equal length. The first samples that make no whole batch are
/// left out. None for fewer than eight samples. (Schmeiser, Oper. Res. 30:556, 1982.)
std::optional<double> batch_uncertainty(const std::vector<double>& samples);
SamplingUncertainty sampling_of(const Trace& trace);

}  // namespace tdbd::simulation
