#pragma once

#include <string>
#include <vector>

#include "bit/cone/cone_measures.hpp"
#include "dynamics/drilling/drilling_step.hpp"
#include "rock/cut/cut_rock.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/motion.hpp"
#include "simulation/step/loads.hpp"
#include "simulation/step/measure.hpp"

namespace tdbd::simulation {

/// Statistics of the rotation of a cone: ratios of its speed to that of the bit, positive for
/// rolling.
struct ConeSummary {
  std::string name;
  long steps = 0;                 ///< in which the bit rotated; if 0, no speed is known
  double mean_speed_ratio = 0.0;  ///< ratio of the rotations of cone and bit over the whole run
  double min_speed_ratio = 0.0;   ///< over single steps
  double max_speed_ratio = 0.0;
  double std_speed_ratio = 0.0;
  double rolling_ratio_gage_row = 0.0;  ///< ratio at which the gage row would roll without slip
  double net_slip_gage_row = 0.0;       ///< 1 - mean over rolling ratio: positive if the cone lags
};

/// State of one cone, as required by the next step.
struct ConeState {
  double angle = 0.0;           ///< rad about its Z since the start; negative for rolling
  double turned = 0.0;          ///< rad, in the last step
  double speed = 0.0;           ///< rad/s in the last step, phi'
  bit::SlipBalance remembered;  ///< sums over all contacts so far, faded with their age
  double start_share = 1.0;     ///< share of the initial pure rolling in the speed

  template <class Archive>
  void serialize(Archive& a) {
    a(angle, turned, speed, remembered, start_share);
  }
};

/// Sets the angle (rad), and `turned` to the difference.
void set_angle(ConeState& cone, double angle);

/// Sums for ConeSummary; positive for rolling.
struct ConeStatistics {
  double bit_turned = 0.0;  ///< rad, since the start
  RunningVariance ratio;    ///< over all steps in which the bit rotated
  double least = 0.0, greatest = 0.0;

  template <class Archive>
  void serialize(Archive& a) {
    a(bit_turned, ratio, least, greatest);
  }
};

/// Adds a step in which the bit rotated by `turn` (rad).
void add(double turn, const std::vector<ConeState>& cones, std::vector<ConeStatistics>& statistics);

std::vector<ConeState> start_cones(const Case& c);

/// Contacts of the teeth of a cone that removed rock in a step: positions of their tips at the
/// given cone angles (rad; middle_angles), weighted by removed volume.
std::vector<bit::ConeContact> contacts_of(const bit::Bit& bit, int cone,
                                          const std::vector<double>& cone_angles,
                                          const rock::CutReport& cut);

/// Rotates the cones through the step that follows `steps_done` steps. At prescribed speeds the
/// angles are those of cone_angles(). A rolling cone has the speed, simulation (2),
///   phi' = e (-i w) + (1 - e) phi'_balance,     phi'_balance = - M / D     (bit::slip_balance) [+]
/// M and D are sums over the contacts of `cut`, which is the previous step, and of all earlier
/// steps, faded by exp(-age / motion.cone_memory). -i w is the pure rolling of the gage row; its
/// share e is 1 until the first contact and fades in the same way from then on. Without contacts a
/// cone keeps its speed.
void turn_cones(const Case& c, long steps_done, const rock::CutReport& cut,
                std::vector<ConeState>& cones);

/// Angles of the cones in the middle of the last step, whose length was dt (s).
std::vector<double> middle_angles(const std::vector<ConeState>& cones, double dt);

/// Angles of the cones, rad, and their speeds in the last step, rad/s.
std::vector<double> angles_of(const std::vector<ConeState>& cones);
std::vector<double> speeds_of(const std::vector<ConeState>& cones);

/// The statistics that a run reports for a cone.
ConeSummary summarize(const bit::Cone& cone, const ConeState& state,
                      const ConeStatistics& statistics);

/// @file
/// Interface between the simulation and the equations of motion (src/dynamics): converts states
/// into poses of the bit relative to the rock, and loads on parts into impulses.

dynamics::Drilling start_drive(const Case& c);

/// Pose of the bit in this state.
Place place_of(const dynamics::DrillingSystem& system, const dynamics::DrillingState& state);

/// Velocity of the bit relative to the rock, in the frame of the rock.
BitVelocity velocity_of(const dynamics::DrillingSystem& system,
                        const dynamics::DrillingState& state);

/// Converts loads to a wrench for the equations of motion: torques about the centre of mass, the
/// opposite force on the rock, and the impulses on the cones' own spins at the end of the step.
/// X_RB is the pose at which the loads were summed; they are about its origin.
dynamics::Wrench wrench_of(const dynamics::DrillingSystem& system, const BitLoads& loads,
                           const Pose& X_RB);

/// Sets the angles and speeds of the cones from the state after a step of dt (s).
void follow_cones(const dynamics::DrillingState& state, double dt, std::vector<ConeState>& cones);

}  // namespace tdbd::simulation
