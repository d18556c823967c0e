#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "core/types.hpp"
#include "string/node_flow.hpp"
#include "string/statics.hpp"
#include "verification/string/wells.hpp"

namespace tdbd::string::modes_test {

using std::numbers::pi;

/// What the step makes of a frequency: sin(w h/2) of the step is w h/2 of the chain.
double stepped(double frequency, double h) { return std::asin(pi * frequency * h) / (pi * h); }

double rod_frequency(int mode, double speed) { return (2 * mode - 1) * speed / 4000.0; }

/// Relative errors of modes 1 to 4 of a rod of 1000 m at a Courant number.
std::vector<double> rod_errors(int elements, double courant) {
  const Section rod = drill_pipe(1000.0);
  const Chain c = make_chain({rod}, vertical(), 0.0, elements);
  const double speed = torsional_wave_speed(rod), h = courant * 1000.0 / elements / speed;
  std::vector<double> errors;
  const auto modes = lowest_modes(c.elements.torsional, c.elements.inertia, 4);
  for (int k = 1; k <= 4; ++k)
    errors.push_back(stepped(modes[at(k - 1)].frequency, h) / rod_frequency(k, speed) - 1.0);
  return errors;
}

TEST(StringModes, rod_frequencies_are_of_second_order_and_exact_at_courant_1) {
  const double reached[] = {9.9e-6, 8.9e-5, 2.5e-4, 4.8e-4};
  const double order_2 = 0.05;
  const auto coarse = rod_errors(40, 0.62), fine = rod_errors(80, 0.62);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(std::abs(fine[k]), reached[k], 0.03 * reached[k]);
    EXPECT_NEAR(std::log2(coarse[k] / fine[k]), 2.0, order_2);
  }
  for (const double error : rod_errors(80, 1.0)) EXPECT_NEAR(error, 0.0, 1e-13);
}

void expect_frequencies(const std::vector<Mode>& modes, const std::vector<double>& exact) {
  const double allowed[] = {2.5e-6, 2.5e-5, 1e-4};
  for (std::size_t k = 0; k < exact.size(); ++k)
    EXPECT_NEAR(modes[k].frequency / exact[k], 1.0, allowed[k]) << "mode " << k + 1;
}

/// Roots of the transcendental equation of two sections and a mass at the end, Hz: in one direction
/// with rigidities (E A or G J), inertias per length and lengths.
struct TwoSections {
  double rigidity[2], inertia[2], length[2], end = 0.0;
};
double end_residual(const TwoSections& s, double frequency) {
  const double w = 2.0 * pi * frequency;
  double u = 0.0, force = 1.0;
  for (int k = 0; k < 2; ++k) {
    const double wave = w * std::sqrt(s.inertia[k] / s.rigidity[k]), x = wave * s.length[k];
    const double z = s.rigidity[k] * wave;
    const double next = u * std::cos(x) + force / z * std::sin(x);
    force = force * std::cos(x) - z * u * std::sin(x);
    u = next;
  }
  return force - w * w * s.end * u;
}
std::vector<double> exact_frequencies(const TwoSections& s, std::size_t count) {
  std::vector<double> roots;
  const double step = 1e-3;
  for (double f = step; roots.size() < count; f += step) {
    double lo = f, hi = f + step;
    if (end_residual(s, lo) * end_residual(s, hi) > 0.0) continue;
    for (int k = 0; k < 60; ++k) {
      const double mid = 0.5 * (lo + hi);
      (end_residual(s, lo) * end_residual(s, mid) <= 0.0 ? hi : lo) = mid;
    }
    roots.push_back(lo);
  }
  return roots;
}

TEST(StringModes, two_sections_and_a_bit_have_the_roots_of_the_transcendental_equation) {
  const auto a = well_a_sections();
  const Chain well = make_chain(a, vertical(), 0.0, 250);
  const TwoSections twist_a{{a[0].torsional_rigidity, a[1].torsional_rigidity},
                            {a[0].inertia, a[1].inertia},
                            {2270.0, 230.0}};
  const auto exact_a = exact_frequencies(twist_a, 3);
  EXPECT_NEAR(exact_a[0], 0.226132, 5e-7);
  EXPECT_NEAR(exact_a[2], 1.292759, 5e-7);
  expect_frequencies(lowest_modes(well.elements.torsional, well.elements.inertia, 3), exact_a);

  const std::vector<Section> s{drill_pipe(2300.0), collars(200.0)};
  const Chain c = make_chain(s, vertical(), 0.0, 250);
  const SimpleBit bit = bit_below(c, 200.0, 1.5, 0.0);
  const auto with_end = [](std::vector<double> masses, double end) {
    masses.back() = end;
    return masses;
  };
  const TwoSections twist{{s[0].torsional_rigidity, s[1].torsional_rigidity},
                          {s[0].inertia, s[1].inertia},
                          {2300.0, 200.0},
                          1.5};
  const TwoSections stretch{
      {s[0].axial_rigidity, s[1].axial_rigidity}, {s[0].mass, s[1].mass}, {2300.0, 200.0}, 200.0};
  EXPECT_NEAR(exact_frequencies(twist, 3)[0], 0.233776, 5e-7);
  EXPECT_NEAR(exact_frequencies(stretch, 3)[2], 2.330970, 5e-7);
  expect_frequencies(
      lowest_modes(c.elements.torsional, with_end(c.elements.inertia, bit.inertia), 3),
      exact_frequencies(twist, 3));
  expect_frequencies(lowest_modes(c.elements.axial, with_end(c.elements.mass, bit.mass), 3),
                     exact_frequencies(stretch, 3));
}

/// A chain that starts in a mode's shape swings as cosine at the frequency of the step.
TEST(StringModes, a_run_swings_at_the_frequency_of_the_mode) {
  const Section rod = drill_pipe(1000.0);
  const Chain c = make_chain({rod}, vertical(), 0.0, 40);
  const SimpleBit bit = bit_below(c, 0.0, 0.0, 0.0);
  const double h = 0.62 * c.elements.length / torsional_wave_speed(rod);
  const Mode mode = lowest_modes(c.elements.torsional, c.elements.inertia, 2)[1];
  Running r = at_rest(c);
  for (std::size_t i = 0; i < 40; ++i) r.state.chain.angle[i] = mode.shape[i];
  r.state.bit.angle = mode.shape[40];
  r.work = chain_work(c, r.state.chain, motion_of(r.state.bit));
  const double w = 2.0 * pi * stepped(mode.frequency, h);
  for (int k = 1; k <= 2000; ++k) {
    step_bit_on_chain(c, bit, h, {}, r.state, r.work);
    ASSERT_NEAR(r.state.bit.angle, mode.shape[40] * std::cos(w * h * k), 1e-11);
  }
}

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

struct Node {
  Slip mass, damping, force;
  Coulomb friction;
};

FreeFlow free_flow(const Node& n, double time, const Slip& w) {
  FreeFlow f;
  f.mobility = {mobility(time, n.mass.along, n.damping.along),
                mobility(time, n.mass.around, n.damping.around)};
  f.speed = {w.along + f.mobility.along * (n.force.along - n.damping.along * w.along),
             w.around + f.mobility.around * (n.force.around - n.damping.around * w.around)};
  return f;
}

Slip flow(const Node& n, double time, const Slip& w) {
  return flow_slip(w, free_flow(n, time, w), n.friction);
}

double energy(const Node& n, const Slip& w) {
  return 0.5 * (n.mass.along * w.along * w.along + n.mass.around * w.around * w.around);
}

TEST(NodeFlow, energy_never_rises_without_a_force) {
  Random random{2007};
  const auto between = [&](double lo, double hi) {
    return lo * std::pow(hi / lo, random.uniform());
  };
  int raised = 0;
  for (int k = 0; k < 30000; ++k) {
    Node n;
    n.mass = {between(1.0, 1e4), between(1.0, 1e4)};
    n.damping = {between(1e-3, 1e4), between(1e-3, 1e4)};
    const double sliding = between(1.0, 1e5);
    n.friction = {sliding * between(1.0, 3.0), sliding, k % 3 == 0 ? 0.0 : between(1e-3, 1.0)};
    const double angle = 6.3 * random.uniform(), size = between(1e-6, 10.0);
    const Slip w{size * std::cos(angle), size * std::sin(angle)};
    raised += energy(n, flow(n, between(1e-6, 1e-2), w)) > energy(n, w) * (1.0 + 1e-15);
  }
  EXPECT_EQ(raised, 0);
}

/// A point whose slip turns while it slides, by flows of h and of h/2: observed order.
TEST(NodeFlow, turning_slip_is_of_second_order) {
  Node n{{3.0, 1.0}, {0.2, 0.1}, {4.0, -9.0}, {2.0, 2.0, 0.0}};
  const auto after = [&](int steps) {
    Slip w{1.0, 2.0};
    for (int k = 0; k < steps; ++k) w = flow(n, 0.3 / steps, w);
    return w;
  };
  const Slip exact = after(100000);
  const auto error = [&](int steps) {
    const Slip w = after(steps);
    return std::hypot(w.along - exact.along, w.around - exact.around);
  };
  EXPECT_NEAR(std::log2(error(40) / error(80)), 2.0, 0.1);
  EXPECT_NEAR(std::log2(error(80) / error(160)), 2.0, 0.1);
}

TEST(NodeFlow, steady_sliding_is_a_fixed_point) {
  for (const double scale : {1e-6, 1.0}) {  // slow: by the size equation; fast: far from rest
    Node n{{3.0, 1.0}, {0.2, 0.1}, {}, {2.0, 2.0, 0.0}};
    const Slip w{0.6 * scale, 0.8 * scale};
    n.force = {2.0 * 0.6 + 0.2 * w.along, 2.0 * 0.8 + 0.1 * w.around};
    const Slip end = flow(n, 1e-3, w);
    // What friction takes in a flow is up to 2e-3 m/s, 1000 times the slow slip.
    const double rounding = scale < 1.0 ? 4e-20 : 4e-16;
    EXPECT_NEAR(end.along, w.along, rounding);
    EXPECT_NEAR(end.around, w.around, rounding);
  }
}

TEST(NodeFlow, static_friction_is_exact_and_ends_beyond_its_bound) {
  Node n{{3.0, 1.0}, {0.2, 0.1}, {1.2, 1.59}, {2.0, 1.0, 0.0}};
  EXPECT_EQ(size_of(flow(n, 1e-3, {})), 0.0);
  n.force.around = 1.61;
  EXPECT_GT(size_of(flow(n, 1e-3, {})), 0.0);
}

/// One direction: the flow of a time is that of its halves, whatever is passed in between.
TEST(NodeFlow, one_direction_is_exact) {
  Random random{7};
  double worst = 0.0;
  for (int k = 0; k < 3000; ++k) {
    const DampedBody body{1.0, k % 4 == 0 ? 0.0 : random.uniform()};
    const double sliding = random.uniform();
    const Coulomb friction{sliding * (1.0 + random.uniform()), sliding,
                           k % 2 == 0 ? 0.0 : 0.3 * random.uniform()};
    const double force = 4.0 * random.uniform() - 2.0, start = 2.0 * random.uniform() - 1.0;
    const double whole = flow_along(body, force, friction, 2.0, start);
    double parts = start;
    for (int i = 0; i < 8; ++i) parts = flow_along(body, force, friction, 0.25, parts);
    worst = std::max(worst, std::abs(parts - whole));
  }
  EXPECT_LE(worst, 3e-14);
}

/// A body that friction brings to rest from w0: its energy and its way.
TEST(NodeFlow, what_came_to_rest_is_booked_to_the_end_of_its_way) {
  const Slip from{0.5, 0.0}, force{1.0, 0.0};
  Lost lost;
  add_flow_losses({from, {0.0, 0.0}, force, 3.0, 1.0}, {2.0, 0.0}, {0.0, 0.0}, lost);
  const double way = 0.5 * 2.0 * 0.25 / (3.0 - 1.0);  // energy over what brakes
  EXPECT_DOUBLE_EQ(lost.friction, 3.0 * way);
}

}  // namespace tdbd::string::modes_test
