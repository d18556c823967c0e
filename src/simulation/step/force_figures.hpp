#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tdbd::simulation {

/// Mean and standard deviation of steps.
struct MeanAndDeviation {
  double mean = 0.0, deviation = 0.0;
};

inline constexpr double sampling_coverage = 0.95;

/// How far means over the steps that count may be from those of an endless run: half-widths of their
/// intervals of 95 %, by the means of eight equal batches. Null where steps are fewer than batches.
/// The error of mesh and time step is no part of it (`tdbd converge`).
struct SamplingUncertainty {
  std::optional<double> wob, tob, rop, rotary_speed;  ///< N, N m, m/s, rad/s
};

/// Of one part of the bit.
struct PartLoadFigures {
  std::string name;
  MeanAndDeviation normal, tangential;  ///< N
  double power = 0.0;                   ///< W, mean
  double removed = 0.0;                 ///< m3, by the part's whole cutter
  double specific_energy = 0.0;         ///< Pa: energy over volume; 0 without volume
};

/// What forces did to the bit over the steps that count. SI.
struct LoadFigures {
  long steps = 0;                      ///< that count; with none, nothing below is known
  double from = 0.0, to = 0.0;         ///< s, of the steps that count
  MeanAndDeviation wob, tob;           ///< N, N m
  MeanAndDeviation rop, rotary_speed;  ///< m/s, rad/s
  SamplingUncertainty uncertainty;
  double aggressiveness = 0.0;         ///< 3 T / (D W); in oilfield units 36 T / (D W)
  double specific_energy = 0.0;        ///< Pa, W/A + w T/(A v), A the gage circle
  double imbalance = 0.0;              ///< mean lateral force in the bit's frame over WOB
  double imbalance_azimuth = 0.0;      ///< rad, of that force in the bit's frame
  double power = 0.0;                  ///< W, mean, spent on the rock
  std::vector<PartLoadFigures> parts;  ///< that a law gave a force
};

/// The figures as `summary.json` has them: wob_mean_n, tob_mean_n_m, rop_mean_m_per_s and more at
/// its top, parts under "forces". Null where no step counts.
nlohmann::ordered_json to_json(const LoadFigures& figures);

}  // namespace tdbd::simulation
