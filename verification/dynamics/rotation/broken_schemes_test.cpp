#include "verification/battery/broken_schemes.hpp"

#include <gtest/gtest.h>

#include "verification/battery/rotation_orders.hpp"
#include "verification/battery/symplectic_defect.hpp"

/// Each check of the battery finds the schemes whose mistake it claims to find. The limits are
/// those of the tests that the program's own drifts pass.
namespace tdbd::battery::broken_schemes_test {

GoldenCase generic() { return read_golden_case("heavy_gyro_phys"); }

double worst_order(const RotationScheme& scheme, std::size_t variable) {
  return observed_orders(scheme, generic())[variable].order;
}
constexpr std::size_t attitude = 0, cone_angles = 3;

double defect(const RotationScheme& scheme) {
  const GoldenCase c = generic();
  return symplectic_defect(scheme, c.gyrostat, c.loads, c.initial, 0.1);
}
constexpr double symplectic_limit = 1e-12;
constexpr double reversible_limit = 1e-12;

TEST(BrokenSchemes, frozen_velocity_is_found_by_order_reversal_symplecticity_and_energy) {
  const RotationScheme broken = frozen_velocity();
  EXPECT_LT(worst_order(broken, attitude), 1.5);
  EXPECT_GT(reversibility_defect(broken, generic(), 0.01, 100), 1e3 * reversible_limit);
  EXPECT_GT(defect(broken), 1e6 * symplectic_limit);
  const EnergyRecord e = energy_record(broken, generic(), 0.04, 100'000);
  EXPECT_GT(std::abs(e.mean_of_fifth.back() - e.mean_of_fifth.front()), 1e-3);
}

TEST(BrokenSchemes, no_way_back_is_found_by_order_and_reversal_and_is_symplectic) {
  const RotationScheme broken = no_way_back();
  EXPECT_LT(worst_order(broken, attitude), 1.5);
  EXPECT_GT(reversibility_defect(broken, generic(), 0.01, 100), 1e3 * reversible_limit);
  EXPECT_LE(defect(broken), symplectic_limit);
}

TEST(BrokenSchemes, hasty_cones_are_found_by_the_cones_order_and_symplecticity) {
  const RotationScheme broken = hasty_cones();
  EXPECT_LT(worst_order(broken, cone_angles), 1.5);
  EXPECT_NEAR(worst_order(broken, attitude), 2.0, 8e-6);
  EXPECT_GT(defect(broken), 1e6 * symplectic_limit);
}

TEST(BrokenSchemes, body_momentum_first_is_found_by_the_momentum) {
  const GoldenCase free = read_golden_case("gyro_free_sym");
  EXPECT_GT(conservation_defects(body_momentum_first(), free, 0.01, 10'000).space_momentum, 0.0);
  const GoldenCase top = read_golden_case("slow_top");
  EXPECT_GT(conservation_defects(body_momentum_first(), top, 0.01, 10'000).vertical_momentum, 0.0);
}

TEST(BrokenSchemes, never_renormalised_is_found_by_the_quaternion) {
  const GoldenCase c = read_golden_case("gyro_free_sym");
  EXPECT_GT(conservation_defects(never_renormalised(), c, 0.01, 10'000).unit_quaternion, 1e-15);
}

TEST(BrokenSchemes, spin_first_is_found_by_the_cones_momenta) {
  EXPECT_GT(conservation_defects(spin_first(), generic(), 0.01, 10'000).cone_momenta, 0.0);
}

}  // namespace tdbd::battery::broken_schemes_test
