#include "bit/mass_properties.hpp"

#include <gtest/gtest.h>

#include "bit/generate.hpp"
#include "bit/surface_of_revolution.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit {
namespace {

mesh::TriangleMesh box(const Vec3& lo, const Vec3& size) {
  mesh::TriangleMesh m;
  for (int k = 0; k < 8; ++k)
    m.positions.push_back(lo + size.cwiseProduct(Vec3(k & 1, (k >> 1) & 1, k >> 2)));
  m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return m;
}

mesh::TriangleMesh sphere(int n) {
  std::vector<Ring> rings{{0.0, 1.0, 1}};
  for (int k = 1; k < n; ++k) rings.push_back({std::sin(pi * k / n), std::cos(pi * k / n), 2 * n});
  rings.push_back({0.0, -1.0, 1});
  return surface_of_revolution(rings);
}

mesh::TriangleMesh moved(mesh::TriangleMesh m, const Pose& X) {
  for (Vec3& p : m.positions) p = X * p;
  return m;
}

Pose any_pose() {
  const Eigen::Quaterniond q(number(0.1, 1), number(-1, 1), number(-1, 1), number(-1, 1));
  return {q.normalized().toRotationMatrix(), {number(-3, 3), number(-3, 3), number(-3, 3)}};
}

RC_GTEST_PROP(mass_properties, of_a_box_are_exact, ()) {
  const Vec3 lo(number(-5, 5), number(-5, 5), number(-5, 5));
  const Vec3 size(number(0.1, 2), number(0.1, 2), number(0.1, 2));
  const MassProperties p = mass_properties(box(lo, size), 2.0);
  const double mass = 2.0 * size.prod();
  const Vec3 s2 = size.cwiseProduct(size);
  const Vec3 diagonal = mass / 12.0 * (Vec3::Constant(s2.sum()) - s2);
  RC_ASSERT(std::abs(p.mass - mass) < 1e-13 * mass);
  RC_ASSERT((p.centre - (lo + 0.5 * size)).norm() < 1e-13);
  RC_ASSERT((p.inertia - Mat3(diagonal.asDiagonal())).norm() < 1e-12 * mass);
}

/// Inscribed polyhedra approach the sphere with the square of the edge: halving it divides by 4.
TEST(mass_properties, of_a_sphere_converge_with_order_2) {
  const auto error = [](int n) {
    const MassProperties p = mass_properties(sphere(n), 1.0);
    EXPECT_LT(p.centre.norm(), 1e-12);
    return std::abs(p.inertia(0, 0) - 8.0 * pi / 15.0);
  };
  for (const int n : {16, 32, 64}) EXPECT_NEAR(std::log2(error(n) / error(2 * n)), 2.0, 0.02);
}

RC_GTEST_PROP(mass_properties, move_with_the_body, ()) {
  const Pose X = any_pose();
  const mesh::TriangleMesh m = box({-1, 0, 2}, {1, 2, 0.5});
  const MassProperties a = transformed(mass_properties(m, 3.0), X);
  const MassProperties b = mass_properties(moved(m, X), 3.0);
  RC_ASSERT(std::abs(a.mass - b.mass) < 1e-13);
  RC_ASSERT((a.centre - b.centre).norm() < 1e-13);
  RC_ASSERT((a.inertia - b.inertia).norm() < 1e-12);
}

RC_GTEST_PROP(mass_properties, of_two_halves_are_those_of_the_whole, ()) {
  const double cut = number(0.1, 0.9);
  const MassProperties whole = mass_properties(box({0, 0, 0}, {1, 2, 3}), 1.0);
  const MassProperties sum = combined(mass_properties(box({0, 0, 0}, {cut, 2, 3}), 1.0),
                                      mass_properties(box({cut, 0, 0}, {1 - cut, 2, 3}), 1.0));
  RC_ASSERT((sum.centre - whole.centre).norm() < 1e-13);
  RC_ASSERT((sum.inertia - whole.inertia).norm() < 1e-12);
}

TEST(mass_properties, of_the_example_bits_are_those_of_bits) {
  for (const char letter : {'a', 'b', 'c'}) {
    const MassProperties p = mass_properties(example_bit(letter));
    EXPECT_GT(p.mass, 20.0);
    EXPECT_LT(p.mass, 80.0);
    EXPECT_LT(std::hypot(p.centre.x(), p.centre.y()), 2e-3);
    EXPECT_NEAR(p.inertia(0, 0), p.inertia(1, 1), 0.02 * p.inertia(0, 0));
  }
}

}  // namespace
}  // namespace tdbd::bit
