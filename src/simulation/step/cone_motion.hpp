#pragma once

#include <string>
#include <vector>

#include "bit/cone/cone_rolling.hpp"
#include "rock/cut/cut_rock.hpp"
#include "simulation/case/case.hpp"
#include "simulation/step/spread.hpp"

namespace tdbd::simulation {

/// How a cone turned: its speed over the bit's, rolling positive.
struct ConeFigures {
  std::string name;
  long steps = 0;                 ///< in which the bit turned; with none, no speed is known
  double mean_speed_ratio = 0.0;  ///< turn of the cone over turn of the bit, whole run
  double min_speed_ratio = 0.0;   ///< of single steps
  double max_speed_ratio = 0.0;
  double std_speed_ratio = 0.0;
  double rolling_ratio_gage_row = 0.0;  ///< at which the gage row would roll without slip
  double net_slip_gage_row = 0.0;       ///< 1 - mean over rolling: positive when the cone lags
};

/// One cone of a run, as the next step needs it.
struct ConeState {
  double angle = 0.0;           ///< rad about its Z since the start; rolling is negative
  double turned = 0.0;          ///< rad, in the last step
  double speed = 0.0;           ///< rad/s in the last step, phi'
  bit::SlipBalance remembered;  ///< of all contacts so far, each faded with its age
  double start_share = 1.0;     ///< of the speed that is still the start's pure rolling
};

/// Turns the cone to this angle (rad).
void set_angle(ConeState& cone, double angle);

/// How a cone turned over the bit; rolling is positive.
struct ConeStatistics {
  double bit_turned = 0.0;  ///< rad, since the start
  Spread ratio;             ///< of all steps in which the bit turned
  double least = 0.0, greatest = 0.0;
};

/// A step in which the bit turned by `turn` (rad).
void add(double turn, const std::vector<ConeState>& cones, std::vector<ConeStatistics>& statistics);

std::vector<ConeState> start_cones(const Case& c);

/// Where the teeth of a cone took rock in a step: at their tips, the cones at these angles (rad;
/// middle_angles), weighed by what they removed.
std::vector<bit::ConeContact> contacts_of(const bit::Bit& bit, int cone,
                                          const std::vector<double>& cone_angles,
                                          const rock::CutReport& cut);

/// Turns the cones through the step that follows `steps_done` steps. At given speeds their angles
/// are those of cone_angles(). A rolling cone turns at, simulation (2),
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
ConeFigures figures_of(const bit::Cone& cone, const ConeState& state,
                       const ConeStatistics& statistics);

}  // namespace tdbd::simulation
