#include "reference/literature/drag/planes/bottom_harmonics.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "battery/generators.hpp"

namespace tdbd::reference::bottom_harmonics_test {
namespace {

std::vector<double> wave(int samples, int lobes, double size, double phase) {
  std::vector<double> depth;
  depth.reserve(at(samples));
  for (int k = 0; k < samples; ++k)
    depth.push_back(0.3 + size * std::cos(2 * std::numbers::pi * lobes * k / samples + phase));
  return depth;
}

constexpr double rounding = 1e-12;

RC_GTEST_PROP(BottomHarmonics, of_a_wave_is_its_size_at_its_alias, ()) {
  const int samples = *battery::integer(3, 130), lobes = *battery::integer(0, 400);
  const int rest = lobes % samples, alias = std::min(rest, samples - rest);
  RC_PRE(alias != 0 && 2 * alias != samples);
  const double size = *battery::number(0.1, 5.0);
  const BottomHarmonics h =
      bottom_harmonics(wave(samples, lobes, size, *battery::number(0.0, 6.0)));
  RC_ASSERT(std::abs(h.amplitude[static_cast<std::size_t>(alias)] - size) < 400 * rounding);
  RC_ASSERT(strongest(h, 1).front() == alias);
  RC_ASSERT(std::abs(h.amplitude[0] - 0.3) < 400 * rounding);
}

TEST(BottomHarmonics, show_73_lobes_as_1_at_72_samples) {
  EXPECT_EQ(strongest(bottom_harmonics(wave(72, 73, 1.0, 0.4)), 1), std::vector{1});
  EXPECT_EQ(strongest(bottom_harmonics(wave(720, 73, 1.0, 0.4)), 1), std::vector{73});
}

TEST(BottomHarmonics, of_alternating_depths_have_no_twin) {
  const BottomHarmonics h = bottom_harmonics({1.0, -1.0, 1.0, -1.0});
  EXPECT_NEAR(h.amplitude[2], 1.0, rounding);
  EXPECT_EQ(h.peak_to_peak, 2.0);
}

TEST(BottomHarmonics, are_taken_on_a_circle_between_nodes) {
  Spokes rock = flat_spokes(10.0, 0.0, 3, 10);  // nodes at 0.5, 1.5, ...
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 10; ++j) rock.depth[at(k * 10 + j)] = k + 2.0 * rock.node_radius(j);
  EXPECT_EQ(depth_on_circle(rock, 4.25), (std::vector{8.5, 9.5, 10.5}));
  EXPECT_EQ(depth_on_circle(rock, 0.1), (std::vector{1.0, 2.0, 3.0}));
  EXPECT_EQ(depth_on_circle(rock, 12.0), (std::vector{19.0, 20.0, 21.0}));
}

}  // namespace
}  // namespace tdbd::reference::bottom_harmonics_test
