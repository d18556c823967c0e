#pragma once

#include <limits>

namespace tdbd::string {

/// How the top of the string is driven.
struct Top {
  enum class Torsion {
    speed,  ///< turns as commanded
    pi,     ///< an inertia, pulled to the commanded angle by a spring and a damper
  };
  enum class Axial {
    rate,        ///< lowered as commanded
    hook_load,   ///< hangs from a commanded force
    autodriller  ///< lowered at a rate that keeps the weight measured at the surface
  };
  Torsion torsion = Torsion::speed;
  double inertia = 0.0;       ///< of the top drive, less what is compensated, kg m2
  double proportional = 0.0;  ///< of the speed: a damper, N m s/rad
  double integral = 0.0;      ///< of the angle: a spring, N m/rad
  double torque_limit = std::numeric_limits<double>::infinity();  ///< N m
  Axial axial = Axial::rate;
  double gain = 0.0;                            ///< of the autodriller, m/s/N
  double integral_gain = 0.0;                   ///< m/s2/N
  double filter = 0.0;                          ///< time constant of the measured weight, s
  double least_rate = 0.0, largest_rate = 0.0;  ///< m/s
  double tare = 0.0;                            ///< hook load that counts as no weight on bit, N
};

/// What the top is to do during one step.
struct TopCommand {
  double turn = 0.0;       ///< of the set point over the step, rad
  double way = 0.0;        ///< of the block over the step, downward, m: Axial::rate
  double hook_load = 0.0;  ///< N: Axial::hook_load
  double weight = 0.0;     ///< to be kept at the surface, N: Axial::autodriller
};

/// What a restart needs of the top.
struct TopState {
  double set_angle = 0.0;       ///< rad
  double set_speed = 0.0;       ///< of the last command, rad/s
  double rate = 0.0;            ///< of the block, m/s
  double hook_load = 0.0;       ///< of the last command, N
  double error_integral = 0.0;  ///< of the autodriller, N s
  double measured = 0.0;        ///< its filtered weight, N
  bool limited = false;         ///< the torque limit was reached in the last flow
};

/// Gains of a top drive that takes the reflection of torsional waves away at one frequency:
/// proportional = factor times the string's impedance, integral = inertia (2 pi frequency)^2.
void tune_soft_torque(Top& top, double impedance, double factor, double frequency);

/// Compensates a share of the inertia and makes proportional = factor times impedance; the integral
/// part stays as given.
void tune_z_torque(Top& top, double impedance, double factor, double share);

/// |(Z - Zt)/(Z + Zt)|, Zt = I s + kp + ki/s, s = 2 pi i f: speed of a torsional wave that comes
/// back from the top over that which goes up.
double reflection(const Top& top, double impedance, double frequency);

/// One flow of the top's rotation, string (7).
struct TopFlow {
  double speed = 0.0;           ///< after it, rad/s
  double motor_impulse = 0.0;   ///< of spring, damper and limit, N m s
  double spring_impulse = 0.0;  ///< of the spring, without a limit, N m s
  bool limited = false;
};

/// The flow of Torsion::pi over a time: `torque` (N m) from the string, `damping` (N m s/rad) of the
/// mud, at the angle `behind` (rad) of the set point ahead of the top.
TopFlow flow_top(const Top& top, double time, double speed, double set_speed, double behind,
                 double torque, double damping, double inertia);

/// The autodriller's next rate from the hook load of this step, string (8).
void drive_block(const Top& top, double step, double hook_load, double set_weight, TopState& state);

}  // namespace tdbd::string
