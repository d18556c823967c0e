#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tdbd::simulation {

/// One variable of the state in which a case ended, as a vector whose length is what differences
/// are measured by. SI.
struct StateVariable {
  std::string name;
  std::string units;
  std::vector<double> values;
  double factor = 1.0;  ///< of the Euclidean norm: 1/sqrt(2) makes the attitude's about an angle
  double scale = 0.0;   ///< size of the variable that errors are relative to
};

/// What a summary says about the end of its case.
struct EndState {
  std::string command;    ///< "run", "rotate"
  double duration = 0.0;  ///< s
  std::vector<StateVariable> variables;
};

/// factor * |a - b|. Both have the same number of values.
double distance(const StateVariable& a, const StateVariable& b);

/// The variables of a summary, as text. Rotation: attitude (Frobenius norm of the difference over
/// sqrt(2): the angle between close attitudes), momenta, angular velocity, cone angles, cone
/// momenta, energy; drilling: volumes. `source` names the summary in messages. Throws InputError
/// when it is no summary of one of these commands.
EndState read_end_state(const std::string& summary, const std::string& source);

/// Of a summary.json, or of the result folder that holds one. Throws InputError.
EndState read_end_state_file(const std::filesystem::path& file_or_folder);

}  // namespace tdbd::simulation
