#include "bit/body/bit_body.hpp"

#include <gtest/gtest.h>

#include "bit/generate.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit::bit_body_test {

constexpr double gage = 107.95e-3;

TEST(BitBody, is_a_closed_solid_that_never_cuts) {
  for (const char letter : {'a', 'b', 'c'}) {
    const Part body = bit_body(table(letter), 0.4, 7850.0, gage);
    EXPECT_TRUE(is_closed_and_oriented(body.mesh_P));
    EXPECT_GT(mesh::enclosed_volume(body.mesh_P), 0.0);
    EXPECT_EQ(body.cutting, Cutting::never);
    EXPECT_EQ(body.density, 7850.0);
  }
}

TEST(BitBody, stays_inside_the_gage_by_the_setback) {
  const Part body = bit_body(table('b'), 0.4, 7850.0, gage);
  double widest = 0.0;
  for (const Vec3& x : body.mesh_P.positions) widest = std::max(widest, x.head<2>().norm());
  EXPECT_NEAR(widest, gage - 0.4 * 19e-3, 1e-12);
}

/// More setback, less body.
TEST(BitBody, shrinks_with_the_setback) {
  const auto volume = [](double setback) {
    return mesh::enclosed_volume(bit_body(table('c'), setback, 1.0, gage).mesh_P);
  };
  EXPECT_GT(volume(0.3), volume(0.4));
  EXPECT_GT(volume(0.4), volume(0.5));
}

/// The order of the table's rows says nothing about the bit.
TEST(BitBody, does_not_depend_on_the_order_of_the_table) {
  std::vector<Cutter> cutters = table('a');
  const Part forwards = bit_body(cutters, 0.4, 1.0, gage);
  std::ranges::reverse(cutters);
  const Part backwards = bit_body(cutters, 0.4, 1.0, gage);
  EXPECT_EQ(mesh::enclosed_volume(forwards.mesh_P), mesh::enclosed_volume(backwards.mesh_P));
}

}  // namespace tdbd::bit::bit_body_test
