#include "bit/cone/tooth_mesh.hpp"

#include <gtest/gtest.h>

#include "bit/cone/cone_faults.hpp"
#include "bit/cone_generate.hpp"
#include "bit/mass_properties.hpp"
#include "mesh/check/check.hpp"
#include "mesh/measures.hpp"
#include "mesh/shape/convex.hpp"

namespace tdbd::bit::tooth_mesh_test {

RC_GTEST_PROP(ToothMesh, is_closed_convex_and_as_high_as_told, ()) {
  const ToothShape t = any_tooth();
  RC_PRE(tooth_faults(t).empty());
  const mesh::TriangleMesh m = tooth_mesh(t, 4 * *rc::gen::inRange(2, 9));
  RC_ASSERT(mesh::check_closed(m).empty());
  RC_ASSERT(mesh::convex_solid(m).has_value());
  const mesh::Box box = mesh::bounding_box(m);
  RC_ASSERT(std::abs(box.hi.z() - t.protrusion) < 1e-15);
  RC_ASSERT(box.lo.z() == -t.embedding);
}

/// The longest crest that a tooth may have, on the coarsest mesh.
TEST(ToothMesh, with_a_crest_as_long_as_the_shank_is_convex) {
  ToothShape t;
  t.kind = ToothKind::chisel;
  t.crest_length = t.diameter;
  t.crest_width = 0.1 * t.diameter;
  for (const int facets : {8, 12, 32})
    EXPECT_TRUE(mesh::convex_solid(tooth_mesh(t, facets)).has_value()) << facets << " facets";
}

TEST(ToothMesh, of_a_chisel_is_as_wide_as_its_shank_up_to_the_shell) {
  ToothShape t;
  t.kind = ToothKind::chisel;
  int on_shank = 0;
  for (const Vec3& x : tooth_mesh(t, 12).positions) {
    if (x.z() > 0.0) continue;
    EXPECT_NEAR(std::hypot(x.x(), x.y()), 0.5 * t.diameter, 1e-15);
    ++on_shank;
  }
  EXPECT_EQ(on_shank, 2 * 12);
}

/// Volume and axial inertia of a cylinder with a half-ball on top approach their closed forms with
/// the square of the edge.
TEST(ToothMesh, of_a_half_ball_converges_with_order_2) {
  ToothShape t;
  t.diameter = 2.0;
  t.protrusion = 1.0;
  t.embedding = 3.0;
  const auto error = [&](int facets) {
    const MassProperties p = mass_properties(tooth_mesh(t, facets), 1.0);
    return std::pair(std::abs(p.mass - (3.0 * pi + 2.0 * pi / 3.0)),
                     std::abs(p.inertia(2, 2) - (3.0 * pi / 2.0 + 4.0 * pi / 15.0)));
  };
  for (const int n : {16, 32, 64}) {
    EXPECT_NEAR(std::log2(error(n).first / error(2 * n).first), 2.0, 0.046);
    EXPECT_NEAR(std::log2(error(n).second / error(2 * n).second), 2.0, 0.05);
  }
}

/// Wedge on a box: prismoids have a closed volume.
TEST(ToothMesh, of_a_milled_tooth_has_the_volume_of_its_prismoid) {
  ToothShape t;
  t.kind = ToothKind::milled_chisel;
  const auto area = [&](double up) {
    return (t.diameter + up * (t.crest_length - t.diameter)) *
           (t.width + up * (t.crest_width - t.width));
  };
  const double wedge = t.protrusion / 6.0 * (area(0) + 4 * area(0.5) + area(1));
  EXPECT_NEAR(mesh::enclosed_volume(tooth_mesh(t, 16)), t.embedding * area(0) + wedge, 1e-20);
}

/// Volume of a shank, a frustum and a ball's cap, which is what a conical insert is: to second order.
TEST(ToothMesh, of_a_conical_insert_converges_with_order_2) {
  ToothShape t;
  t.kind = ToothKind::conical;
  t.diameter = 2.0;
  t.protrusion = 1.6;
  t.embedding = 1.0;
  t.tip_radius = 0.5;
  t.half_angle = 0.6;
  const double c = std::cos(0.6), s = std::sin(0.6), r = 0.5 * c;  // where flank and ball touch
  const double flank = (1.0 - r) / std::tan(0.6), cap = 0.5 * (1.0 - s),
               shank = 1.0 + 1.6 - cap - flank;
  const double volume =
      pi * shank + pi * flank / 3.0 * (1.0 + r + r * r) + pi * cap * cap / 3.0 * (3.0 * 0.5 - cap);
  const auto error = [&](int facets) {
    return volume - mesh::enclosed_volume(tooth_mesh(t, facets));
  };
  EXPECT_GT(error(32), 0.0);  // inscribed
  for (const int n : {16, 32, 64}) EXPECT_NEAR(std::log2(error(n) / error(2 * n)), 2.0, 0.025);
}

/// The box of what stands at the top of a tooth.
Vec3 crest_of(const mesh::TriangleMesh& m, double top) {
  mesh::TriangleMesh crest;
  for (const Vec3& x : m.positions)
    if (x.z() > top - 1e-9) crest.positions.push_back(x);
  return mesh::bounding_box(crest).size();
}

/// A crest is as long along X and as wide along Y as told, a chisel's but for the facets of its shank.
TEST(ToothMesh, has_the_crest_that_was_asked) {
  ToothShape t;
  t.kind = ToothKind::milled_chisel;
  const Vec3 milled = crest_of(tooth_mesh(t, 16), t.protrusion);
  EXPECT_NEAR(milled.x(), t.crest_length, 1e-15);
  EXPECT_NEAR(milled.y(), t.crest_width, 1e-15);
  t.kind = ToothKind::chisel;
  for (const int facets : {8, 16, 64}) {
    const double short_of = std::cos(pi / facets);
    const Vec3 chisel = crest_of(tooth_mesh(t, facets), t.protrusion);
    EXPECT_NEAR(chisel.x(), t.crest_length * short_of, 1e-15);
    EXPECT_NEAR(chisel.y(), t.crest_width * short_of, 1e-15);
  }
}

/// As many facets around as asked, and a quarter as many rings up a ball, two at least.
TEST(ToothMesh, is_as_fine_as_asked) {
  ToothShape t;
  for (const int facets : {8, 16, 32}) {
    const auto n = static_cast<std::size_t>(facets), rings = std::max<std::size_t>(2, n / 4);
    t.kind = ToothKind::hemispherical;
    EXPECT_EQ(tooth_mesh(t, facets).positions.size(), n * (1 + rings) + 1);
    t.kind = ToothKind::conical;
    EXPECT_EQ(tooth_mesh(t, facets).positions.size(), n * (2 + rings) + 1);
    t.kind = ToothKind::chisel;
    EXPECT_EQ(tooth_mesh(t, facets).positions.size(), 3 * n);
    t.kind = ToothKind::milled_chisel;
    EXPECT_EQ(tooth_mesh(t, facets).positions.size(), 12U);
  }
}

std::string first_fault(const ToothShape& t) {
  const auto faults = tooth_faults(t);
  return faults.empty() ? "" : faults.front().key;
}

TEST(ToothMesh, has_faults_for_what_no_tooth_can_be) {
  ToothShape t;
  EXPECT_EQ(first_fault(t), "");
  t.diameter = -1e-3;
  EXPECT_EQ(first_fault(t), "diameter");
  t = {};
  t.embedding = -1e-3;
  EXPECT_EQ(first_fault(t), "embedding");
  t = {.protrusion = 1e-3, .embedding = 4e-3};
  EXPECT_EQ(first_fault(t), "embedding") << "the half-ball ends below the shank";
  t = {.kind = ToothKind::chisel, .crest_length = 13e-3};
  EXPECT_EQ(first_fault(t), "crest_length");
  t = {.kind = ToothKind::chisel, .crest_length = 2e-3, .crest_width = 3e-3};
  EXPECT_EQ(first_fault(t), "crest_width");
  t = {.kind = ToothKind::milled_chisel, .width = 1e-3};
  EXPECT_EQ(first_fault(t), "crest_width");
  t = {.kind = ToothKind::conical, .tip_radius = 9e-3};
  EXPECT_EQ(first_fault(t), "tip_radius");
  t = {.kind = ToothKind::conical, .tip_radius = 1e-3, .half_angle = 0.1};
  EXPECT_EQ(first_fault(t), "half_angle");
}

}  // namespace tdbd::bit::tooth_mesh_test
