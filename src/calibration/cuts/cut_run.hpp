#pragma once

#include <string>
#include <vector>

#include "calibration/case/calibration_case.hpp"
#include "simulation/case/case.hpp"
#include "simulation/step/cuts.hpp"

namespace tdbd::calibration {

/// The mean cuts of a tool's parts at one depth of cut, in the tool's own frame: what
/// simulation::CutOfPart calls W is the bit's frame B here, of which z points down the hole and
/// about which it turns; a single cutter's is that of groove_cut.hpp. They depend on tool and depth
/// alone (calibration (1)): one cut run serves every pressure, speed and coefficient.
struct CutRun {
  double depth = 0.0;  ///< m, a revolution of a bit; a cutter's groove
  std::vector<simulation::CutOfPart> cuts;
};

/// Which cut run a record needs: the depth to a picometre, so that rounding in the units of a file
/// makes no second run.
double depth_of_run(const Record& record);

/// The case of a cut run: a steady kinematic run of the bit at this depth of cut (m a revolution).
simulation::Case cut_case(const CalibrationCase& c, const Tool& bit, double depth);

/// Runs it, and takes the mean over its last revolution, calibration (1). Throws RunError.
CutRun make_cut_run(const simulation::Case& c, double depth, long steps_per_revolution);

}  // namespace tdbd::calibration
