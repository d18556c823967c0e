#pragma once

#include <string>
#include <vector>

#include "reference/literature/roller/craters/cone_recursion.hpp"
#include "reference/literature/roller/craters/cone_torques.hpp"
#include "reference/literature/roller/craters/tooth_prints.hpp"
#include "reference/literature/roller/craters/weight_balance.hpp"

/// The common part of the models of Ma, Zhou and Deng and of Huang and Cawthorne (thesis 2.2): a
/// bit that turns at a constant speed, cones that turn under the forces of their teeth, teeth that
/// press into a bottom of craters, and the depth of the bit at which they carry the weight.
namespace tdbd::reference {

/// How cones are advanced in a step.
enum class ConeUpdate {
  increments,  ///< the recursion of eq. (2.5), reading (iii)
  speeds,      ///< speed and angle alternately, from inertia and forces
};

/// How the bit's depth is determined. `balance`: the teeth carry the weight at every time; the
/// depth is found by iteration. `mass`: a mass that the weight pushes down and the teeth support.
/// The iteration is the limit of a vanishing mass.
enum class AxialMotion { balance, mass };

/// Where a tooth contacts the bottom: only at its tip, whose depth is the variable of tables of
/// single-tooth tests; or on its whole round end (round_end.hpp), including ridges beside the tip.
/// Depths are vertical, so on the vertical walls of a groove the force on a round end is too large.
enum class ToothContact { point, round_end };

/// The initial bottom: flat, or with a round groove for every row, as its teeth leave it in a turn
/// without advance, so that all rows are in contact at once.
enum class BottomStart { flat, grooves };

struct CraterDrillingOptions {
  std::string model = "Ma, Zhou and Deng";  ///< for messages
  PrintOptions print = {};
  ToothContact contact = ToothContact::point;
  double end_spacing = 0.5e-3;  ///< m, between the points of a round end
  double end_height = 4e-3;     ///< m, height up to which it has points
  SlidingOptions sliding = {};
  BalanceOptions balance = {};
  ConeUpdate way = ConeUpdate::increments;
  double torque_average = 0.0;  ///< s, time constant of the mean of a cone's torque; 0: no mean
  double first_ratio = 1.5;     ///< initial ratio of cone speed to bit speed
  double prescribed_ratio_revolutions = 0.0;  ///< of the bit, during which that ratio is prescribed
  AxialMotion axial = AxialMotion::balance;
  double mass = 5000.0;        ///< kg, for AxialMotion::mass
  double axial_damping = 0.0;  ///< N s/m, on that mass
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

/// Time series, all of one length. Values of teeth are in the order of place_teeth.
struct RollerSeries {
  std::vector<double> time;               ///< s
  std::vector<double> depth;              ///< m, of the bit
  std::vector<double> weight, torque;     ///< N, N m, carried by the rock
  std::vector<double> side_x, side_y;     ///< N, on the bit, in space
  std::vector<int> contacts;              ///< number of teeth in the rock
  std::vector<int> evaluations;           ///< of the weight, needed to find the depth
  std::vector<double> cone_speeds;        ///< rad/s, [step * cones + cone]
  std::vector<double> forces_in_contact;  ///< N, vertical, of all teeth in the rock after `settle`
};

/// All results of a run. Means are taken after `settle`.
struct RollerRun {
  RollerSeries series;
  std::vector<double> tooth_force;     ///< N, mean of each tooth over all time
  std::vector<double> tooth_largest;   ///< N, largest force of each tooth in a step after `settle`
  std::vector<double> tooth_contacts;  ///< fraction of time in which each tooth is in the rock
  std::vector<double> tooth_volume;    ///< m3, by each tooth
  std::vector<double> cone_ratio;      ///< mean cone speed over bit speed (negative: rolling)
  double rate = 0.0;                   ///< m/s
  double weight = 0.0, weight_deviation = 0.0;     ///< N
  double torque = 0.0, torque_deviation = 0.0;     ///< N m
  double contacts = 0.0, contacts_variance = 0.0;  ///< teeth
  double deepest_print = 0.0;                      ///< m
  long beyond_law = 0;   ///< number of tooth-steps deeper than the last row of the table
  PrintVolumes volumes;  ///< m3, of the whole run
  ZMap bottom;
};

/// Drills `schedule.revolutions` from a new bottom. Does not allocate in a step. Throws InputError
/// that begins with the model's name: no cones, no teeth, a cone without inertia, a law that
/// check_tooth_law rejects, a schedule without weight, or no depth that carries the weight.
RollerRun crater_drilling(const RollerBit& bit, const ToothLaw& law, const RollerSchedule& schedule,
                          const CraterDrillingOptions& options);

}  // namespace tdbd::reference
