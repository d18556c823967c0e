#include "rock/section/flat_behind.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bit/cutter/cutter_frame.hpp"
#include "bit/cutter/cutter_parts.hpp"
#include "bit/wear/worn_piece.hpp"
#include "core/angles.hpp"

namespace tdbd::rock::flat_behind_test {
namespace {

constexpr double worn = 0.4e-3;  // m

bit::Cutter cutter(double chamfer, double side_rake) {
  bit::Cutter c;
  c.diameter = 16e-3;
  c.tip_radius = 70e-3;
  c.azimuth = 0.7;
  c.tip_height = 5e-3;
  c.profile_angle = 0.5;
  c.back_rake = 20.0 * degree;
  c.side_rake = side_rake;
  c.chamfer = chamfer;
  c.chamfer_angle = 45.0 * degree;
  c.length = 13e-3;
  c.table_thickness = 2e-3;
  c.wear = worn;
  c.X_BC = bit::cutter_pose(c);
  return c;
}

struct Made {
  bit::Bit bit;
  FlatBehind flat;
};

Made made(const bit::Cutter& c, int rim_segments) {
  Made m;
  m.bit.cutters = {c};
  m.bit.parts = bit::cutter_parts(c, {.rim_segments = rim_segments});
  for (bit::Part& part : m.bit.parts) part.cutter = 0;
  m.flat = flat_behind(c, 0, face_outline(c, 0, m.bit.parts), m.bit.parts);
  return m;
}

/// The area of the table's own flat, measured on the triangles.
double area_on_mesh(const bit::Bit& bit) {
  const bit::WearSolid solid = bit::wear_solids(bit)[0];
  return bit::flat_at(solid, solid.start).area;
}

/// A cylinder with a leaning face: A_seg(y)/sin b of the reference, y = wear/cos b.
TEST(FlatBehind, has_the_area_of_a_cut_cylinder_with_order_2) {
  const bit::Cutter c = cutter(0.0, 0.0);
  const double a = 0.5 * c.diameter, y = worn / std::cos(c.back_rake);
  const double exact = (a * a * std::acos(1.0 - y / a) - (a - y) * std::sqrt(2.0 * a * y - y * y)) /
                       std::sin(c.back_rake);
  const auto error = [&](int n) {
    return std::abs(flat_between(made(c, n).flat, -1.0, 1.0).area - exact);
  };
  EXPECT_NEAR(std::log2(error(1024) / error(4096)), 4.0, 0.3);
  EXPECT_LT(error(4096), 1e-4 * exact);
}

TEST(FlatBehind, is_the_flat_of_a_sharp_cutters_mesh) {
  constexpr double beside = 1e-7;  // flat_at measures 1e-9 of the diameter beside the table's flat
  const Made m = made(cutter(0.0, 0.0), 64);
  const double area = area_on_mesh(m.bit);
  EXPECT_NEAR(flat_between(m.flat, -1.0, 1.0).area, area, beside * area);
}

/// Strips that begin on both sides of any place add up, in area and moment.
TEST(FlatBehind, adds_up_over_its_edge) {
  const Made m = made(cutter(0.3e-3, 5.0 * degree), 64);
  const FlatPiece whole = flat_between(m.flat, -1.0, 1.0);
  EXPECT_GT(whole.area, 0.0);
  EXPECT_LT(whole.area, area_on_mesh(m.bit));
  for (const double y : {-1.3e-3, 0.0, 0.2e-3, 1.1e-3}) {
    const FlatPiece left = flat_between(m.flat, -1.0, y), right = flat_between(m.flat, y, 1.0);
    EXPECT_NEAR(left.area + right.area, whole.area, 1e-12 * whole.area);
    EXPECT_LT((left.moment_F + right.moment_F - whole.moment_F).norm(),
              1e-12 * whole.moment_F.norm());
  }
}

/// Its middle lies in the plane of the flat, behind the edge.
TEST(FlatBehind, has_its_middle_in_the_flat) {
  const bit::Cutter c = cutter(0.3e-3, 5.0 * degree);
  const Made m = made(c, 64);
  const FlatPiece whole = flat_between(m.flat, -1.0, 1.0);
  const Vec3 middle_F = whole.moment_F / whole.area;
  const Vec3 middle_B = face_outline(c, 0, m.bit.parts).X_BF * middle_F;
  EXPECT_LT(middle_F.x(), 0.0);
  EXPECT_NEAR(bit::profile_normal_B(c).dot(middle_B - bit::tip_B(c)), -worn, 1e-12);
}

TEST(FlatBehind, is_empty_without_wear) {
  bit::Cutter c = cutter(0.3e-3, 0.0);
  c.wear = 0.0;
  EXPECT_TRUE(made(c, 64).flat.columns.columns.empty());
}

}  // namespace
}  // namespace tdbd::rock::flat_behind_test
