#pragma once

#include <string>
#include <vector>

#include "bit/cone/cone_rolling.hpp"
#include "rock/cut/cut_rock.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// A cone's turn over the bit's, step by step; rolling is positive.
struct SpeedRatios {
  long count = 0;
  double least = 0.0, greatest = 0.0;
  double mean = 0.0;
  double squares = 0.0;  ///< sum of the squared distances from the mean
};

void add(SpeedRatios& ratios, double ratio);

/// How a cone turned: its speed over the bit's, rolling positive.
struct ConeFigures {
  std::string name;
  double mean_speed_ratio = 0.0;  ///< turn of the cone over turn of the bit, whole run
  double min_speed_ratio = 0.0;   ///< of single steps
  double max_speed_ratio = 0.0;
  double std_speed_ratio = 0.0;
  double rolling_ratio_gage_row = 0.0;  ///< at which the gage row would roll without slip
  double net_slip_gage_row = 0.0;       ///< 1 - mean over rolling: positive when the cone lags
};

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
rotation::Twist twist_between(const Pose& X_WB0, const Pose& X_WB1, double dt);

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
