#pragma once

#include <string>
#include <vector>

#include "reference/literature/roller/craters/cone_recursion.hpp"
#include "reference/literature/roller/craters/cone_torques.hpp"
#include "reference/literature/roller/craters/tooth_prints.hpp"
#include "reference/literature/roller/craters/weight_balance.hpp"

/// What the models of Ma, Zhou and Deng and of Huang and Cawthorne (thesis 2.2) have in common: a bit that
/// turns at a constant speed, cones that turn under the forces of their teeth, teeth that press into a
/// bottom of craters, and a depth of the bit at which they carry the weight.
namespace tdbd::reference {

/// How cones turn in a step.
enum class ConeWay {
  increments,  ///< the recursion of eq. (2.5), reading (iii)
  speeds,      ///< speed and angle in turn, from inertia and forces
};

/// What holds the bit's depth: the weight at every moment, found by iteration, or a mass that the weight
/// presses down and the teeth hold. The iteration is what a mass tends to as it vanishes.
enum class AxialMotion { balance, mass };

/// Where a tooth feels the bottom: at its point alone, whose depth is what a table of single-tooth tests
/// knows; or all over its round end (round_end.hpp), also on ridges beside the point. Depths are vertical: on
/// the upright walls of a groove a round end feels too much.
enum class ToothContact { point, round_end };

/// The bottom at the start: level, or with a round groove for every row, as its teeth leave it in a turn
/// without advance, so that all rows touch at once.
enum class BottomStart { flat, grooves };

struct CraterDrillingOptions {
  std::string model = "Ma, Zhou and Deng";  ///< for messages
  PrintOptions print = {};
  ToothContact contact = ToothContact::point;
  double end_spacing = 0.5e-3;  ///< m, of a round end's points
  double end_height = 4e-3;     ///< m, to which it has points
  SlidingOptions sliding = {};
  BalanceOptions balance = {};
  ConeWay way = ConeWay::increments;
  double torque_average =
      0.0;                   ///< s, over which a cone's torque is averaged (time constant); 0: not
  double first_ratio = 1.5;  ///< cone speed over bit speed at the start
  double given_revolutions = 0.0;  ///< of the bit, during which that ratio is kept
  AxialMotion axial = AxialMotion::balance;
  double mass = 5000.0;        ///< kg, for AxialMotion::mass
  double axial_damping = 0.0;  ///< N s/m, against that mass
  BottomStart start = BottomStart::grooves;
  double cell = 0.5e-3;  ///< m, of the bottom
};

struct RollerSchedule {
  double bit_speed = 0.0;    ///< rad/s
  double weight = 0.0;       ///< N
  double step = 1e-3;        ///< s
  double revolutions = 3.0;  ///< of the bit
  double settle = 1.0;       ///< revolutions before means are taken
};

/// Step by step, of one length. Tooth values stand in the order of place_teeth.
struct RollerSeries {
  std::vector<double> time;               ///< s
  std::vector<double> depth;              ///< m, of the bit
  std::vector<double> weight, torque;     ///< N, N m, that the rock carries
  std::vector<double> side_x, side_y;     ///< N, on the bit, in space
  std::vector<int> contacts;              ///< teeth in the rock
  std::vector<int> evaluations;           ///< of the weight, to find the depth
  std::vector<double> cone_speeds;        ///< rad/s, [step * cones + cone]
  std::vector<double> forces_in_contact;  ///< N, vertical, of all teeth in the rock after `settle`
};

/// Everything of a run; means are taken after `settle`.
struct RollerRun {
  RollerSeries series;
  std::vector<double> tooth_force;     ///< N, mean of each tooth over all time
  std::vector<double> tooth_largest;   ///< N, largest force of each tooth in a step after `settle`
  std::vector<double> tooth_contacts;  ///< share of the time that each tooth is in the rock
  std::vector<double> tooth_volume;    ///< m3 that each tooth dug
  std::vector<double> cone_ratio;      ///< mean cone speed over bit speed (negative: rolling)
  double rate = 0.0;                   ///< m/s
  double weight = 0.0, weight_deviation = 0.0;     ///< N
  double torque = 0.0, torque_deviation = 0.0;     ///< N m
  double contacts = 0.0, contacts_variance = 0.0;  ///< teeth
  double deepest_print = 0.0;                      ///< m
  long beyond_law = 0;   ///< tooth-steps deeper than the last row of the table
  PrintVolumes volumes;  ///< m3, of the whole run
  ZMap bottom;
};

/// Drills `schedule.revolutions` from a new bottom. Nothing is allocated in a step.
/// Throws InputError, beginning with the model's name: no cones, no teeth, a cone without inertia, a law
/// that check_tooth_law refuses, a schedule without weight, no depth that carries the weight.
RollerRun crater_drilling(const RollerBit& bit, const ToothLaw& law, const RollerSchedule& schedule,
                          const CraterDrillingOptions& options);

}  // namespace tdbd::reference
