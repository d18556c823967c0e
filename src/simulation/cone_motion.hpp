#pragma once

#include <string>
#include <vector>

#include "bit/cone_rolling.hpp"
#include "rock/cut_rock.hpp"
#include "simulation/case.hpp"
#include "simulation/summary.hpp"

namespace tdbd::simulation {

/// A cone's turn over the bit's, step by step; rolling is positive.
struct SpeedRatios {
  long count = 0;
  double least = 0.0, greatest = 0.0;
  double mean = 0.0;
  double squares = 0.0;  ///< sum of the squared distances from the mean
};

void add(SpeedRatios& ratios, double ratio);

/// One cone of a run.
struct ConeState {
  double angle = 0.0;           ///< rad about its Z since the start; rolling is negative
  double speed = 0.0;           ///< rad/s in the last step, phi'
  double rolling_ratio = 0.0;   ///< bit::rolling_ratio_of_gage_row
  bit::SlipBalance remembered;  ///< of all contacts so far, each faded with its age
  double start_share = 1.0;     ///< of the speed that is still the start's pure rolling
  double bit_turned = 0.0;      ///< rad, since the start
  SpeedRatios ratios;           ///< of all steps in which the bit turned
};

std::vector<ConeState> start_cones(const Case& c);

/// The twist that takes the bit from one pose to the next in the time dt (s), in its own frame.
/// Exact for a screw motion; else of second order in dt at the middle of the way.
bit::Twist twist_between(const Pose& X_WB0, const Pose& X_WB1, double dt);

/// Where the teeth of a cone took rock in a step: at their tips, the cones at these angles (rad;
/// middle_angles), weighed by what they removed.
std::vector<bit::ConeContact> contacts_of(const bit::Bit& bit, int cone,
                                          const std::vector<double>& cone_angles,
                                          const rock::CutReport& cut);

/// Turns the cones through the step that follows `steps_done` steps. At given speeds their angles
/// are those of cone_angles(). A rolling cone turns at
///   phi' = e (-i w) + (1 - e) phi'_balance,     phi'_balance = - M / D     (bit::slip_balance) [+]
/// with M and D summed over the contacts of `cut`, the step before, and of all earlier steps, faded
/// by exp(-age / cone_memory); -i w the pure rolling of its gage row and e its share, 1 until the
/// first contact and faded from there likewise. Without contacts a cone keeps its speed.
void turn_cones(const Case& c, long steps_done, const rock::CutReport& cut,
                std::vector<ConeState>& cones);

/// Angles of the cones in the middle of the last step, whose length was dt (s).
std::vector<double> middle_angles(const std::vector<ConeState>& cones, double dt);

/// Angles of the cones, rad, and their speeds in the last step, rad/s.
std::vector<double> angles_of(const std::vector<ConeState>& cones);
std::vector<double> speeds_of(const std::vector<ConeState>& cones);

/// What a run reports of a cone.
ConeFigures figures_of(const std::string& name, const ConeState& cone);

}  // namespace tdbd::simulation
