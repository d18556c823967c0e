#pragma once

#include <string>
#include <vector>

#include "core/config/config.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// N per m of diameter: 10 000 lbf per inch, at which the teeth of the hardest roller cone bits
/// break (Bourgoyne, Millheim, Chenevert and Young, Applied Drilling Engineering, 1986, (W/d)max of
/// the table of tooth wear; from memory). Bits with cutters carry less.
inline constexpr double most_weight_per_diameter = 1.75e6;

/// Returns the width (m) of the narrowest part that cuts: the middle one of the three sizes of its
/// box. 0 without parts that cut.
double narrowest_width(const bit::Bit& bit);

/// Returns a warning for each value that is legal but probably unintended: edges of the rock longer
/// than half of the width of the narrowest part that cuts (the surface does not resolve the cut),
/// edges that are coarse for the forces on teeth, means that begin at or after the end of the run, sections closer than the longest edge, a weight
/// on bit above most_weight_per_diameter, an attachment from which the bit topples, and a time step
/// that does not resolve the contact of the bit with its wall.
std::vector<CaseWarning> doubtful_values(const Config& c, const Case& read);

/// Upper bounds of the bit's speeds during one piece of its motion.
struct Speeds {
  double shift = 0.0;       ///< m/s, of the bit's origin
  Vec3 w_B = Vec3::Zero();  ///< rad/s, of the rotation except that of the axis
  double swing = 0.0;       ///< rad/s, of the axis
  long line = 0;            ///< of the path's file, at the end of the piece; 0: none
};

/// Returns the speeds of a motion: one entry for a steady or whirling bit, one per piece of a path.
std::vector<Speeds> speeds_of(const Motion& m);

/// Records a mistake for the first piece of the motion that is too fast for the time step: along a
/// path, a turn of more than 0.5 rad in a step (read_case checks other motions earlier); or the
/// middle of a part that cuts moves farther in one step than the diagonal of the part's box. The
/// sweep uses the part at both ends of a step and straight lines in between.
void check_step_length(Config& c, const Case& read);

}  // namespace tdbd::simulation
