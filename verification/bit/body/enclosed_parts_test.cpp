#include "bit/body/enclosed_parts.hpp"

#include <gtest/gtest.h>

#include "bit/generate.hpp"
#include "bit/surface_of_revolution.hpp"

namespace tdbd::bit::enclosed_parts_test {

Part cylinder(double radius, double from, double to) {
  Part p;
  p.density = 1.0;
  p.mesh_P =
      surface_of_revolution({{0, to, 1}, {radius, to, 32}, {radius, from, 32}, {0, from, 1}});
  return p;
}

/// One in the other, whatever their frames; half out, or without a density, is not.
RC_GTEST_PROP(EnclosedParts, are_found_in_any_frame, ()) {
  const Eigen::Quaterniond q(number(0.1, 1), number(-1, 1), number(-1, 1), number(-1, 1));
  const Pose X_BP{q.normalized().toRotationMatrix(), {number(-1, 1), number(-1, 1), number(-1, 1)}};
  Bit bit;
  bit.parts = {cylinder(0.1, 0.1, 0.2), cylinder(0.3, 0.0, 1.0), cylinder(0.1, 0.9, 1.1)};
  for (Part& part : bit.parts) part.X_BP = X_BP;
  RC_ASSERT(enclosed_parts(bit) == (std::vector<std::pair<int, int>>{{0, 1}}));
  bit.parts[0].density = 0.0;
  RC_ASSERT(enclosed_parts(bit).empty());
}

TEST(EnclosedParts, of_the_example_bits_are_none) {
  for (const char letter : {'a', 'b', 'c'})
    EXPECT_TRUE(enclosed_parts(example_bit(letter)).empty());
}

}  // namespace tdbd::bit::enclosed_parts_test
