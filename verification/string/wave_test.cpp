#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/types.hpp"
#include "verification/string/wells.hpp"

namespace tdbd::string::wave_test {

/// A hump with a plateau in its middle; its ramps (m) have three continuous derivatives.
struct Pulse {
  double ramp = 0.0, plateau = 0.0;
  double operator()(double x) const {
    if (x <= 0.0 || x >= 2.0 * ramp + plateau) return 0.0;
    const double y = std::min({x, ramp, 2.0 * ramp + plateau - x}) / ramp;
    return std::pow(y, 4) * (35.0 - 84.0 * y + 70.0 * y * y - 20.0 * y * y * y);
  }
};

/// Pipe over collars whose top moves as the pulse: displacements of all nodes after `time`.
struct Field {
  std::vector<double> along, around;
};
Field field_after(double time, double h, int elements, const Pulse& pulse, double top_speed[2]) {
  const Chain c = make_chain({drill_pipe(4000.0), collars(4000.0)}, vertical(), 0.0, elements);
  SimpleBit bit = bit_below(c, 0.0, 0.0, 0.0);
  Chain weightless = c;
  weightless.contact.weight.assign(at(elements) + 1, 0.0);
  bit.gravity_force = 0.0;
  Running r = at_rest(weightless);
  const long steps = std::lround(time / h);
  for (long k = 0; k < steps; ++k) {
    const double t = static_cast<double>(k) * h;
    TopCommand command;
    command.way = pulse(top_speed[0] * (t + h)) - pulse(top_speed[0] * t);
    command.turn = pulse(top_speed[1] * (t + h)) - pulse(top_speed[1] * t);
    step_bit_on_chain(weightless, bit, h, command, r.state, r.work);
  }
  return {r.state.chain.displacement, r.state.chain.angle};
}

/// Reflection and transmission of displacement by impedances.
double transmitted(double above, double below) { return 2.0 * above / (above + below); }

TEST(StringWaves, a_change_of_section_reflects_and_transmits_by_impedance) {
  const Section upper = drill_pipe(1.0), lower = collars(1.0);
  const double t_around = transmitted(torsional_impedance(upper), torsional_impedance(lower));
  const double t_along = transmitted(std::sqrt(upper.axial_rigidity * upper.mass),
                                     std::sqrt(lower.axial_rigidity * lower.mass));
  EXPECT_NEAR(t_around, 0.288876, 5e-7);
  EXPECT_NEAR(t_along, 0.327233, 5e-7);
  // Both pulses are 2000 m long; after 6600 m of way they have left the change at 4000 m.
  const Pulse pulse{900.0, 200.0};
  double speeds[2] = {axial_wave_speed(upper), torsional_wave_speed(upper)};
  const double h = 0.9 * 10.0 / speeds[0];
  const auto at_depth = [](const std::vector<double>& field, double depth) {
    return field[at(static_cast<int>(depth / 10.0))];
  };
  const Field along = field_after(6600.0 / speeds[0], h, 800, pulse, speeds);
  const Field around = field_after(6600.0 / speeds[1], h, 800, pulse, speeds);
  const double stretched = 1.5e-6,
               turned = 3e-5;  // the ramps' dispersion, at Courant numbers 0.9, 0.56
  EXPECT_NEAR(at_depth(along.along, 4000.0 + 1600.0), t_along, stretched);
  EXPECT_NEAR(at_depth(along.along, 4000.0 - 1600.0), t_along - 1.0, stretched);
  EXPECT_NEAR(at_depth(around.around, 4000.0 + 1600.0), t_around, turned);
  EXPECT_NEAR(at_depth(around.around, 4000.0 - 1600.0), t_around - 1.0, turned);
}

/// Largest error of the torsional field behind and before the change, by d'Alembert.
double field_error(double element, double courant) {
  const Section upper = drill_pipe(1.0);
  const double t = transmitted(torsional_impedance(upper), torsional_impedance(collars(1.0)));
  const Pulse pulse{80.0, 0.0};
  double speeds[2] = {axial_wave_speed(upper), torsional_wave_speed(upper)};
  const double h = courant * element / speeds[1];
  const double steps = std::round(560.0 / (h * speeds[1])), way = steps * h * speeds[1];
  const Chain c = make_chain({drill_pipe(400.0), collars(400.0)}, vertical(), 0.0,
                             static_cast<int>(800.0 / element));
  Chain turning = c;
  turning.directions = Directions::torsion;
  const SimpleBit bit = bit_below(turning, 0.0, 0.0, 0.0);
  Running r = at_rest(turning);
  for (int k = 0; k < static_cast<int>(steps); ++k) {
    TopCommand command;
    command.turn = pulse(speeds[1] * h * (k + 1)) - pulse(speeds[1] * h * k);
    step_bit_on_chain(turning, bit, h, command, r.state, r.work);
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < r.state.chain.angle.size(); ++i) {
    const double s = element * static_cast<double>(i);
    const double exact =
        s > 400.0 ? t * pulse(way - s) : pulse(way - s) + (t - 1.0) * pulse(way - (800.0 - s));
    worst = std::max(worst, std::abs(r.state.chain.angle[i] - exact));
  }
  return worst;
}

TEST(StringWaves, the_field_is_exact_at_courant_1_and_of_second_order_below) {
  EXPECT_LE(field_error(10.0, 1.0), 2e-15);
  const double coarse = field_error(5.0, 0.62), fine = field_error(2.5, 0.62);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.2);
  EXPECT_LE(fine, 1e-2);
}

}  // namespace tdbd::string::wave_test
