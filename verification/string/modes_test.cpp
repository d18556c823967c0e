#include "string/modes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/types.hpp"
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

}  // namespace tdbd::string::modes_test
