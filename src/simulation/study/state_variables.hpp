#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dynamics/drilling/drilling_system.hpp"

namespace tdbd::simulation {

/// One variable of the state in which a case ended, as a vector whose length is what differences
/// are measured by. SI.
struct StateVariable {
  std::string name;
  std::string units;
  std::vector<double> values;
  double factor = 1.0;  ///< of the Euclidean norm: 1/sqrt(2) makes the attitude's about an angle
  double scale = 0.0;   ///< size of the variable that errors are relative to
  bool grows = false;   ///< other levels may have more values; those that are missing are 0
};

/// What a summary says about the end of its case.
struct EndState {
  std::string command;    ///< "run", "rotate"
  double duration = 0.0;  ///< s
  std::vector<StateVariable> variables;
};

/// factor * |a - b|. Both have the same number of values, or grow.
double distance(const StateVariable& a, const StateVariable& b);

/// The variables of a summary, as text. Rotation: attitude (Frobenius norm of the difference over
/// sqrt(2): the angle between close attitudes), momenta, angular velocity, cone angles, cone
/// momenta, energy; drilling: volumes and means of weight, torque, rate, rotary speed, power and
/// normal forces by part. What a summary does not know is left out. `source` names the summary in
/// messages. Throws InputError when it is no summary of one of these commands.
EndState read_end_state(const std::string& summary, const std::string& source);

/// Adds where a bit that forces move is, over the rock (m), and its momenta; no summary says these.
void add_motion(const dynamics::DrillingState& state, EndState& end);

/// Of a summary.json, or of the result folder that holds one. Throws InputError.
EndState read_end_state_file(const std::filesystem::path& file_or_folder);

}  // namespace tdbd::simulation
