#include "bit/body/body_overlap.hpp"

#include <gtest/gtest.h>

#include "bit/body/blade_body.hpp"
#include "bit/generate_design.hpp"
#include "bit/surface_of_revolution.hpp"
#include "mesh/measures.hpp"
#include "mesh/search/inside.hpp"
#include "mesh/shape/clip_convex.hpp"
#include "mesh/shape/convex.hpp"

namespace tdbd::bit::body_overlap_test {

constexpr double rounding = 1e-12;  ///< m3; scale: the sizes below, about 1 m

mesh::TriangleMesh placed_cylinder(const Pose& X) {
  mesh::TriangleMesh m =
      surface_of_revolution({{0, 0.4, 1}, {0.3, 0.4, 12}, {0.5, -0.4, 12}, {0, -0.4, 1}});
  for (Vec3& x : m.positions) x = X * x;
  return m;
}

Pose any_pose() {
  const Eigen::Quaterniond q(number(0.1, 1), number(-1, 1), number(-1, 1), number(-1, 1));
  return {q.normalized().toRotationMatrix(),
          {number(-0.6, 0.6), number(-0.6, 0.6), number(-0.6, 0.6)}};
}

/// Two convex solids: clipping one by the other's planes is another way to the same volume.
RC_GTEST_PROP(BodyOverlap, of_convex_solids_is_what_their_planes_leave, ()) {
  const mesh::TriangleMesh a = placed_cylinder(any_pose()), b = placed_cylinder(any_pose());
  const auto planes = mesh::convex_solid(b);
  RC_ASSERT(planes.has_value());
  mesh::TriangleMesh clipped = a;
  for (std::size_t i = 0; i < planes->planes && !clipped.triangles.empty(); ++i)
    clipped = mesh::clipped_convex(clipped, mesh::normal(*planes, i), planes->b[i]);
  const double volume = clipped.triangles.empty() ? 0.0 : mesh::enclosed_volume(clipped);
  RC_ASSERT(std::abs(common_volume(a, b) - volume) < rounding);
  RC_ASSERT(std::abs(common_volume(b, a) - volume) < rounding);
}

Bit bladed() {
  PdcOptions options;
  options.blades = BladeOptions{};
  return pdc_bit("plain", lay_out(plain_design()).cutters, options);
}

/// A body without density has its volume counted elsewhere: nothing is to be taken from it.
TEST(BodyOverlap, is_none_with_a_body_without_density) {
  Bit bit = bladed();
  std::erase_if(bit.parts, [](const Part& p) { return p.cutter >= 0 && p.cutter != 20; });
  EXPECT_GT(cutters_in_body(bit), 0.0);
  bit.parts.back().density = 0.0;
  EXPECT_EQ(cutters_in_body(bit), 0.0);
}

/// A cutter's body and blades: the share of a grid of its points that lies inside.
TEST(BodyOverlap, of_cutters_in_blades_is_what_a_grid_of_points_finds) {
  const Bit bit = bladed();
  const Cutter& c = bit.cutters[20];
  const mesh::TriangleTree blades(bit.parts.back().mesh_P);
  mesh::TriangleMesh body;
  for (const Part& part : bit.parts)
    if (part.cutter == 20 && part.kind == PartKind::cutter_body) body = part.mesh_P;
  for (Vec3& x : body.positions) x = c.X_BC * x;
  constexpr int steps = 60;
  int hits = 0, points = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j)
      for (int k = 0; k < steps; ++k) {
        const double y = (2.0 * j + 1) / steps - 1, z = (2.0 * k + 1) / steps - 1;
        if (y * y + z * z >= 1.0) continue;
        const double front = chamfer_depth(c),
                     depth = front + (c.length - front) * (i + 0.5) / steps;
        ++points;
        hits += mesh::inside(blades, c.X_BC * Vec3(-depth, y * c.diameter / 2, z * c.diameter / 2));
      }
  const double share = static_cast<double>(hits) / points;
  EXPECT_GT(share, 0.2);
  EXPECT_LT(share, 0.9);
  const double whole = mesh::enclosed_volume(body);
  EXPECT_NEAR(common_volume(body, bit.parts.back().mesh_P) / whole, share, 1.4e-3);
}

}  // namespace tdbd::bit::body_overlap_test
