#include "bit/cone/cone_assumptions.hpp"

#include <gtest/gtest.h>

#include "bit/files/bit_reading.hpp"
#include "bit/mass_properties.hpp"

namespace tdbd::bit::cone_assumptions_test {

/// The modulations are shares of the bit's inertia about its own axis, and the torque that is left out is
/// W^2 (A1 / 2 + A2): bit (11), bit (12). A bit off its axis has the more inertia about it.
TEST(ConeAssumptions, are_shares_of_the_inertia_about_the_axis) {
  Bit b = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  constexpr double speed = 12.0;
  for (const double aside : {0.0, 0.02}) {
    for (Part& part : b.parts)
      if (part.kind == PartKind::bit_body) part.X_BP.p.x() += aside;
    const MassProperties m = mass_properties(b);
    const double inertia = m.inertia(2, 2) + m.mass * m.centre.head<2>().squaredNorm();
    const ConeAssumptions a = cone_assumptions(b, 0, speed, 1.4);
    EXPECT_GT(a.torque_error, 0.0);
    EXPECT_NEAR(a.torque_error,
                speed * speed * inertia * (0.5 * a.modulation_once + a.modulation_twice),
                1e-14 * a.torque_error);
  }
}

}  // namespace tdbd::bit::cone_assumptions_test
