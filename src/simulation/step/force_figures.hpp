#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

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
struct LoadFigures {
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
nlohmann::ordered_json to_json(const LoadFigures& figures);

}  // namespace tdbd::simulation
