#pragma once

#include <string>
#include <vector>

#include "calibration/case/calibration_case.hpp"
#include "simulation/case/case.hpp"
#include "simulation/step/cuts.hpp"

namespace tdbd::calibration {

/// The mean cuts of the parts of a tool at one depth of cut, in the frame of the tool: quantities
/// that simulation::CutOfPart gives in frame W are in the frame B of the bit here, whose z axis
/// points down the hole and is its axis of rotation. The frame of a single cutter is that of
/// cut_run.hpp. The cuts depend only on tool and depth (calibration (1)), so one cut run is used
/// for all pressures, speeds and coefficients.
struct CutRun {
  double depth = 0.0;  ///< m: per revolution of a bit, or of the groove of a cutter
  std::vector<simulation::CutOfPart> cuts;
};

/// The depth of the cut run for a record, rounded to a picometre, so that rounding in the units of
/// a file does not cause a second run.
double depth_of_run(const Record& record);

/// The case of a cut run: a steady run of the bit in prescribed motion at this depth of cut (m per
/// revolution).
simulation::Case cut_case(const CalibrationCase& c, const Tool& bit, double depth);

/// Runs the case and averages over its last revolution, calibration (1). Throws RunError.
CutRun make_cut_run(const simulation::Case& c, double depth, long steps_per_revolution);

/// The cut of a single cutter that moves along flat rock in a groove of this depth (m), from
/// geometry (calibration (2)). Frame: x along the motion, z into the rock. The cutter is on an arm
/// of 1 m along -y, so that the torque about z equals its drag and a cutter test is evaluated like
/// that of a bit. A wear flat and a chamfer press on the rock as one part of kind chamfer.
/// `ahead_share` is the share of the depth, from the top, that chips off ahead of the face (rock
/// (21)); the face cuts the rest.
CutRun groove_cut(const SingleCutter& cutter, double depth, double ahead_share = 0.0);

}  // namespace tdbd::calibration
