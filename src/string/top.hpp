#pragma once

#include <limits>

namespace tdbd::string {

/// Drive at the top of the string.
struct Top {
  enum class Torsion {
    speed,  ///< rotates at the commanded speed
    pi,     ///< an inertia with a spring and a damper to the commanded angle
  };
  enum class Axial {
    rate,        ///< lowered at the commanded rate
    hook_load,   ///< suspended by a commanded force
    autodriller  ///< lowered at a rate that controls the weight measured at the surface
  };
  Torsion torsion = Torsion::speed;
  double inertia = 0.0;       ///< of the top drive, minus the compensated part, kg m2
  double proportional = 0.0;  ///< gain on speed: a damper, N m s/rad
  double integral = 0.0;      ///< gain on angle: a spring, N m/rad
  double torque_limit = std::numeric_limits<double>::infinity();  ///< N m
  Axial axial = Axial::rate;
  double gain = 0.0;                            ///< of the autodriller, m/s/N
  double integral_gain = 0.0;                   ///< m/s2/N
  double filter = 0.0;                          ///< time constant of the measured weight, s
  double least_rate = 0.0, largest_rate = 0.0;  ///< m/s
  double tare = 0.0;                            ///< hook load at zero weight on bit, N
};

/// Commands to the top for one step.
struct TopCommand {
  double turn = 0.0;       ///< rotation of the set point over the step, rad
  double way = 0.0;        ///< displacement of the block over the step, downward, m: Axial::rate
  double hook_load = 0.0;  ///< N: Axial::hook_load
  double weight = 0.0;     ///< set point at the surface, N: Axial::autodriller
};

/// State of the top, sufficient for a restart.
struct TopState {
  double set_angle = 0.0;       ///< rad
  double set_speed = 0.0;       ///< of the last command, rad/s
  double rate = 0.0;            ///< of the block, m/s
  double hook_load = 0.0;       ///< of the last command, N
  double error_integral = 0.0;  ///< of the autodriller, N s
  double measured = 0.0;        ///< filtered weight of the autodriller, N
  bool limited = false;         ///< the torque limit was reached in the last flow

  template <class Archive>
  void serialize(Archive& a) {
    a(set_angle, set_speed, rate, hook_load, error_integral, measured, limited);
  }
};

/// Sets the gains of a top drive so that it does not reflect torsional waves at one frequency:
/// proportional = factor times the impedance of the string, integral = inertia (2 pi frequency)^2.
void tune_soft_torque(Top& top, double impedance, double factor, double frequency);

/// Compensates a share of the inertia and sets proportional = factor times impedance. The integral
/// gain is unchanged.
void tune_z_torque(Top& top, double impedance, double factor, double share);

/// Reflection coefficient of torsional waves at the top: |(Z - Zt)/(Z + Zt)|, Zt = I s + kp + ki/s,
/// s = 2 pi i f. It is the ratio of the speeds of the downgoing and the upgoing wave.
double reflection(const Top& top, double impedance, double frequency);

/// Result of one flow of the rotation of the top, string (7).
struct TopFlow {
  double speed = 0.0;           ///< after the flow, rad/s
  double motor_impulse = 0.0;   ///< of spring, damper and limit, N m s
  double spring_impulse = 0.0;  ///< of the spring, without a limit, N m s
  bool limited = false;
};

/// The flow of Torsion::pi over `time`. `torque` (N m) comes from the string, `damping` (N m s/rad)
/// from the mud; `behind` (rad) is the angle by which the top lags the set point.
TopFlow flow_top(const Top& top, double time, double speed, double set_speed, double behind,
                 double torque, double damping, double inertia);

/// Sets the next rate of the autodriller from the hook load of this step, string (8).
void update_block_rate(const Top& top, double step, double hook_load, double set_weight,
                       TopState& state);

}  // namespace tdbd::string
