#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "rock/rock.hpp"
#include "simulation/result/summary.hpp"
#include "simulation/study/state_variables.hpp"

namespace tdbd::simulation {

/// The rock at the end of a level, for comparisons between levels.
struct Hole {
  mesh::TriangleMesh rock;  ///< the whole surface
  mesh::TriangleMesh cut;   ///< triangles with a corner that the bit moved in this run
  double edge = 0.0;        ///< m, median edge length of the cut triangles; 0: nothing was cut
};

Hole hole_of(const rock::Rock& rock);

/// Distance between two holes, and the radius for relative distances.
struct HoleDifference {
  double largest = 0.0;  ///< m: symmetric Hausdorff distance of the cut parts
  double volume = 0.0;   ///< m3, between the surfaces: mean of the integrals in both directions
  double radius = 0.0;   ///< m: half the largest width of the cut parts
};

/// Sampled at half the smaller edge length. Zero if neither was cut.
HoleDifference difference(const Hole& a, const Hole& b);

/// Options of a study.
struct ConvergenceOptions {
  int threads = 1;
  const std::atomic<bool>* interrupted = nullptr;
  /// Called repeatedly with the level (from 1), the steps done and the total number of steps.
  std::function<void(int, long, long)> progress;
};

/// Result of a case at one level.
struct LevelOutcome {
  RunStatus status = RunStatus::completed;
  double step = 0.0;  ///< s, as used
  long steps = 0;
  EndState end;
  std::optional<Hole> hole;  ///< for a drilling case
  long evaluations = 0;      ///< torque evaluations, for a rotation
};

/// Runs a case in memory, either a rotate case or a run. `number` is that of the level, for the
/// progress. Throws InputError, RunError.
LevelOutcome run_level(const std::string& case_file, const std::vector<std::string>& overrides,
                       int number, const ConvergenceOptions& options);

}  // namespace tdbd::simulation
