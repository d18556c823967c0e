#pragma once

#include <string>
#include <vector>

#include "core/config/config.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// How fast the bit goes during a piece of its motion, from above.
struct Speeds {
  double shift = 0.0;       ///< m/s, of the bit's origin
  Vec3 w_B = Vec3::Zero();  ///< rad/s, of the turn that the axis does not take part in
  double swing = 0.0;       ///< rad/s, of the axis
  long line = 0;            ///< of the path's file, where the piece ends; 0: none
};

/// Bounds of the speeds: one for a steady or whirling bit, one for each piece of a path.
std::vector<Speeds> speeds_of(const Motion& m);

/// Notes in the Config the first piece of the motion that is too fast for the time step: a turn of
/// more than 0.5 rad in a step along a path (other motions are asked sooner), or the middle of a
/// part that cuts going farther in one step than the diagonal of the part's box. The sweep knows
/// the part at both ends of a step and straight lines in between. Formulation 2.1.
void note_long_steps(Config& c, const Case& read);

}  // namespace tdbd::simulation
