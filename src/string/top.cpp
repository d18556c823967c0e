#include "string/top.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "string/node_flow.hpp"

namespace tdbd::string {

void tune_soft_torque(Top& top, double impedance, double factor, double frequency) {
  const double w = 2.0 * std::numbers::pi * frequency;
  top.proportional = factor * impedance;
  top.integral = top.inertia * w * w;
}

void tune_z_torque(Top& top, double impedance, double factor, double share) {
  top.inertia *= 1.0 - share;
  top.proportional = factor * impedance;
}

double reflection(const Top& top, double impedance, double frequency) {
  if (top.torsion == Top::Torsion::speed) return 1.0;
  const std::complex<double> s(0.0, 2.0 * std::numbers::pi * frequency);
  const std::complex<double> zt = top.inertia * s + top.proportional + top.integral / s;
  return std::abs((impedance - zt) / (impedance + zt));
}

TopFlow flow_top(const Top& top, double time, double speed, double set_speed, double behind,
                 double torque, double damping, double inertia) {
  const double spring = top.integral * behind;
  const auto flow = [&](double force, double resistance) {
    return speed + mobility(time, inertia, resistance) * (force - resistance * speed);
  };
  TopFlow f;
  f.spring_impulse = time * spring;
  f.speed = flow(torque + spring + top.proportional * set_speed, damping + top.proportional);
  const auto mean_motor = [&] {
    return spring + top.proportional * (set_speed - 0.5 * (speed + f.speed));
  };
  if (const double motor = mean_motor(); std::abs(motor) > top.torque_limit) {
    const double limit = std::copysign(top.torque_limit, motor);
    f.limited = true;
    f.motor_impulse = time * limit;
    f.speed = flow(torque + limit, damping);
    return f;
  }
  // Impulse of the motor: the change of momentum minus the impulses of string and mud.
  const double resisted = damping * 0.5 * (speed + f.speed) * time;
  f.motor_impulse = inertia * (f.speed - speed) - time * torque + resisted;
  return f;
}

void update_block_rate(const Top& top, double step, double hook_load, double set_weight,
                       TopState& state) {
  const double weight = top.tare - hook_load;
  const double share = top.filter > 0.0 ? -std::expm1(-step / top.filter) : 1.0;
  state.measured += share * (weight - state.measured);
  const double error = set_weight - state.measured;
  const double integral = state.error_integral + step * error;
  const double wanted = top.gain * error + top.integral_gain * integral;
  state.rate = std::clamp(wanted, top.least_rate, top.largest_rate);
  if (state.rate == wanted) state.error_integral = integral;  // no wind-up
}

}  // namespace tdbd::string
