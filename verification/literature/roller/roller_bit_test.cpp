#include "reference/literature/roller/roller_bit.hpp"

#include <gtest/gtest.h>

namespace tdbd::reference::roller_bit_test {
namespace {

TEST(RollerBit, journal_axes_are_a_right_handed_frame_with_the_direction_of_rotation) {
  RollerCone cone;
  cone.journal_angle = 0.6;
  const JournalAxes axes = journal_axes(cone);
  EXPECT_NEAR((axes.s.cross(axes.u) - Vec3::UnitY()).norm(), 0.0, 1e-15);
  EXPECT_GT(axes.s.z(), 0.0);
}

}  // namespace
}  // namespace tdbd::reference::roller_bit_test
