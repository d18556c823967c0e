#include "rotation/quaternion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "rotation/screw.hpp"

namespace tdbd::rotation::quaternion_test {

constexpr double rounding = 3e-15;

Vec3 random_vector() {
  const auto component = [] { return 1e-5 * *rc::gen::inRange(-600'000, 600'000); };
  const double x = component(), y = component(), z = component();
  return {x, y, z};
}

RC_GTEST_PROP(QuaternionExp, is_the_rotation_of_rodrigues_formula, ()) {
  const Vec3 v = random_vector();
  const Eigen::Quaterniond q = quaternion_exp<double>(v);
  RC_ASSERT(std::abs(q.squaredNorm() - 1.0) <= rounding);
  RC_ASSERT((q.toRotationMatrix() - exp(v)).norm() <= 3.0 * rounding);
}

TEST(Renormalise, makes_a_defect_its_square) {
  Eigen::Quaterniond q = quaternion_exp<double>(Vec3(0.3, -0.2, 1.0));
  q.coeffs() *= 1.0 + 1e-6;
  renormalise(q);
  EXPECT_NEAR(q.norm(), 1.0, 2e-12);
  renormalise(q);
  EXPECT_NEAR(q.norm(), 1.0, rounding);
}

}  // namespace tdbd::rotation::quaternion_test
