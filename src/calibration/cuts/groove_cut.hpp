#pragma once

#include "calibration/case/calibration_case.hpp"
#include "calibration/cuts/cut_run.hpp"

namespace tdbd::calibration {

/// The cut of a single cutter that moves along flat rock in a groove of this depth (m), from
/// geometry (calibration (2)). Frame: x along the motion, z into the rock. The cutter is on an arm
/// of 1 m along -y, so that the torque about z equals its drag and a cutter test is evaluated like
/// that of a bit. A wear flat and a chamfer press on the rock as one part of kind chamfer.
/// `ahead_share` is the share of the depth, from the top, that chips off ahead of the face (rock
/// (21)); the face cuts the rest.
CutRun groove_cut(const SingleCutter& cutter, double depth, double ahead_share = 0.0);

}  // namespace tdbd::calibration
