#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/drilling/drilling_system.hpp"
#include "mesh/triangle_mesh.hpp"
#include "rock/rock.hpp"
#include "simulation/result/summary.hpp"

namespace tdbd::simulation {

/// A state variable at the end of a case, as a vector. Differences are measured by its length. SI
/// units.
struct StateVariable {
  std::string name;
  std::string units;
  std::vector<double> values;
  double factor = 1.0;  ///< of the Euclidean norm: 1/sqrt(2) gives angles for attitudes
  double scale = 0.0;   ///< magnitude of the variable, for relative errors
  bool grows = false;   ///< levels may have different numbers of values; missing ones are 0
};

/// The end of a case as described by its summary.
struct EndState {
  std::string command;    ///< "run", "rotate"
  double duration = 0.0;  ///< s
  std::vector<StateVariable> variables;
};

/// factor * |a - b|. Both must have the same number of values, or `grows`.
double distance(const StateVariable& a, const StateVariable& b);

/// Reads the variables from the text of a summary. Rotation: attitude (Frobenius norm of the
/// difference over sqrt(2), which is the angle between close attitudes), momenta, angular velocity,
/// cone angles, cone momenta, energy. Drilling: volumes and means of weight, torque, rate of
/// penetration, rotary speed, power and normal forces by part. Variables not in the summary are
/// omitted. `source` names the summary in messages. Throws InputError if it is not the summary of
/// one of these commands.
EndState read_end_state(const std::string& summary, const std::string& source);

/// Adds the position of a bit in free motion relative to the rock (m) and its momenta, which are
/// not in the summary.
void add_motion(const dynamics::DrillingState& state, EndState& end);

/// Reads a summary.json, or that of a result folder. Throws InputError.
EndState read_end_state_file(const std::filesystem::path& file_or_folder);

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
