#pragma once

#include <string>
#include <vector>

#include "core/config/config.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// Upper bounds of the bit's speeds during a piece of its motion.
struct Speeds {
  double shift = 0.0;       ///< m/s, of the bit's origin
  Vec3 w_B = Vec3::Zero();  ///< rad/s, of the rotation other than that of the axis
  double swing = 0.0;       ///< rad/s, of the axis
  long line = 0;            ///< of the path's file, where the piece ends; 0: none
};

/// The speeds of a motion: one entry for a steady or whirling bit, one for each piece of a path.
std::vector<Speeds> speeds_of(const Motion& m);

/// Notes in the Config the first piece of the motion that is too fast for the time step: along a
/// path, a turn of more than 0.5 rad in a step (read_case checks other motions sooner); or the
/// middle of a part that cuts goes farther in one step than the diagonal of the part's box. The
/// sweep knows the part at both ends of a step and straight lines in between.
void check_step_length(Config& c, const Case& read);

}  // namespace tdbd::simulation
