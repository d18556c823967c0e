#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dynamics/drilling/drilling_system.hpp"

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

}  // namespace tdbd::simulation
