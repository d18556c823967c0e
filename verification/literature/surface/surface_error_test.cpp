#include "reference/literature/surface/surface_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tdbd::reference::surface_error_test {

constexpr double pi = std::numbers::pi;

/// A cone of 30 degrees: cosine sqrt(3)/2 everywhere.
ProfileCosine cone() { return {{0.2, 0.9}, {pi / 6, pi / 6}}; }

ZMap raised(double by) {
  ZMap map = flat_z_map(1.0, 0.5, 400);
  for (double& z : map.height) z += by;
  return map;
}

TEST(SurfaceError, of_a_shifted_surface_is_the_shift_along_the_normal) {
  const auto e = surface_errors(raised(0.0), raised(-0.01), cone(), {0.3, 0.6, 0.9});
  ASSERT_EQ(e.size(), 2U);
  for (const SurfaceError& ring : e) {
    EXPECT_NEAR(ring.mean_signed, -0.01 * std::sqrt(0.75), 1e-12);
    EXPECT_NEAR(ring.mean, 0.01 * std::sqrt(0.75), 1e-12);
    EXPECT_NEAR(ring.p95, ring.mean, 1e-12);
    EXPECT_NEAR(ring.rms, ring.mean, 1e-12);
    const double area = pi * (ring.r_hi * ring.r_hi - ring.r_lo * ring.r_lo);
    EXPECT_NEAR(ring.volume, -0.01 * area, 0.01 * 9e-4 * area);  // cells on the rim
  }
}

/// A ramp in x: distances are uniform over the disc's chords, the largest twentieth beyond p95.
TEST(SurfaceError, percentiles_are_those_of_the_distances) {
  ZMap ramp = raised(0.0);
  for (int i = 0; i < ramp.cells * ramp.cells; ++i)
    ramp.height[static_cast<std::size_t>(i)] += -1.0 + (i % ramp.cells + 0.5) * ramp.cell();
  const ProfileCosine flat{{0.0, 1.0}, {0.0, 0.0}};
  const auto e = surface_errors(raised(0.0), ramp, flat, {0.0, 0.9}).front();
  // |x| <= c on a share (2/pi) (c sqrt(1 - c^2) + asin c) of a unit disc: 0.95 at c = 0.8783.
  EXPECT_NEAR(e.p95, 0.8783 * 0.9, 0.005);
  EXPECT_NEAR(e.rms, 0.45, 5e-5);                       // R/2
  EXPECT_NEAR(e.mean, 4.0 * 0.9 / (3.0 * pi), 5.5e-5);  // 4 R/(3 pi)
  EXPECT_NEAR(e.mean_signed, 0.0, 1e-12);
}

TEST(SurfaceError, refuses_other_cells) {
  EXPECT_THROW(surface_errors(raised(0.0), flat_z_map(1.0, 0.0, 10), cone(), {0.0, 1.0}),
               std::invalid_argument);
}

}  // namespace tdbd::reference::surface_error_test
