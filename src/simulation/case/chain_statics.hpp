#pragma once

#include <string>
#include <vector>

#include "string/section.hpp"
#include "string/statics.hpp"

namespace tdbd::simulation {

/// Static torque and drag without mud: how the string moves, and what it carries.
struct StaticLoad {
  std::string name;  ///< "pull_up", "slack_off", "rotate", "drill"
  string::SteadyLoad load;
};

/// Loads of a chain off bottom, whose last element carries `hanging` (N), and with the pull and torque of
/// `start` where these differ from hanging.
std::vector<StaticLoad> static_loads(const string::Chain& chain, double hanging,
                                     const string::SteadyMotion& start);

/// The first three free vibrations of each kind, the top standing still, the bit off bottom.
struct ChainModes {
  std::vector<string::Mode> axial, torsional;
};

/// `mass` (kg) and `inertia` (kg m2): of the bit, the last cell included.
ChainModes chain_modes(const string::Chain& chain, double mass, double inertia);

/// Elements that the fastest waves pass in a step.
struct CourantNumbers {
  double axial = 0.0, torsional = 0.0;
};
CourantNumbers courant_numbers(const std::vector<string::Section>& sections, double element_length,
                               double step);

}  // namespace tdbd::simulation
