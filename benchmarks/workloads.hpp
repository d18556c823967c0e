#pragma once

#include <string>
#include <vector>

#include "benchmarks/drilling.hpp"
#include "benchmarks/rival_drilling.hpp"

namespace tdbd::bench {

/// A TDBD drilling that benchmarks measure: a case at an edge length, with further settings.
struct Workload {
  std::string name;          ///< standard-1.0
  std::string of;            ///< the case's name in `cases`
  double edge_length = 0.0;  ///< m
  std::vector<std::string> settings;
  std::string what;  ///< description
};

/// The workloads of the goals in the README.
const std::vector<Workload>& workloads();

/// Bit B at 2.0 mm with a trimmed wall, used by `metre`.
const Workload& metre_workload();

/// A height field in which the standard workload is drilled for comparison.
struct ZMapWorkload {
  std::string name;   ///< z-map-0.5
  double cell = 0.0;  ///< m
  std::string what;
};
const std::vector<ZMapWorkload>& z_map_workloads();

/// The drilling after its first revolution, or for a TDBD workload after `warm_steps` if that is
/// not negative.
Drilling start_workload(const Workload& w, const std::vector<std::string>& more_settings = {},
                        long warm_steps = -1);
RivalDrilling<reference::ZMap> start_workload(const ZMapWorkload& w);

/// The standard workload on Langeveld's 120 spokes of 500 nodes, after its first revolution.
RivalDrilling<reference::Spokes> start_spokes_workload();

}  // namespace tdbd::bench
