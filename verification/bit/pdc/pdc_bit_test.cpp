#include "bit/pdc/pdc_bit.hpp"

#include <gtest/gtest.h>

#include "bit/generate.hpp"
#include "core/error.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit::pdc_bit_test {

constexpr double gage = 107.95e-3;

TEST(PdcBit, reaches_its_gage_exactly) {
  for (const char letter : {'a', 'b', 'c'})
    EXPECT_NEAR(example_bit(letter).gage_radius, gage, 1e-15);
}

TEST(PdcBit, keeps_the_order_of_the_table) {
  const Bit bit = example_bit('b');
  ASSERT_EQ(bit.parts.size(), 3 * 28u + 1u);
  for (int i = 0; i < 28; ++i) {
    const std::string cutter = "cutter-" + std::to_string(i + 1);
    EXPECT_EQ(bit.parts[3 * i].name, cutter + "/face");
    EXPECT_EQ(bit.parts[3 * i + 1].name, cutter + "/chamfer");
    EXPECT_EQ(bit.parts[3 * i + 2].name, cutter + "/body");
    for (int k = 0; k < 3; ++k) EXPECT_EQ(bit.parts[3 * i + k].group, i);
  }
  EXPECT_EQ(bit.parts.back().name, "bit-body");
  EXPECT_EQ(bit.parts.back().cutting, Cutting::never);
}

TEST(PdcBit, has_closed_parts_with_outward_normals) {
  PdcOptions options;
  options.pads.count = 5;
  for (const char letter : {'a', 'b', 'c'})
    for (const Part& part : example_bit(letter, options).parts) {
      EXPECT_TRUE(is_closed_and_oriented(part.mesh_P)) << part.name;
      EXPECT_GT(mesh::enclosed_volume(part.mesh_P), 0.0) << part.name;
    }
}

/// No vertex of the body reaches the groove of any cutter near it: the body stays behind the tips.
TEST(PdcBit, sets_its_body_back_behind_the_cutters) {
  for (const char letter : {'a', 'b', 'c'}) {
    const Bit bit = example_bit(letter);
    for (const Vec3& x : bit.parts.back().mesh_P.positions)
      for (const Cutter& c : bit.cutters) {
        const Vec3 n = profile_normal_B(c);
        const double r = std::hypot(x.x(), x.y()) - c.tip_radius, z = x.z() + c.tip_height;
        if (std::hypot(r, z) > c.diameter) continue;
        const double height = std::sin(c.profile_angle) * r + n.z() * z;
        EXPECT_LT(height, -0.2 * c.diameter) << letter << c.id;
      }
  }
}

TEST(PdcBit, without_cutters_is_an_error) { EXPECT_THROW(pdc_bit("none", {}, {}), InputError); }

}  // namespace tdbd::bit::pdc_bit_test
