#include "rock/section/face_outline.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "bit/cutter/cutter_frame.hpp"
#include "bit/cutter/cutter_parts.hpp"
#include "verification/battery/generators.hpp"
#include "verification/bit/generate.hpp"

namespace tdbd::rock::face_outline_test {

/// Scale of the tolerances: a cutter's place, below a metre.
constexpr double rounding = 1e-14;

RC_GTEST_PROP(FaceOutline, is_the_circle_through_the_tip_up_to_the_wear_flat, ()) {
  bit::Cutter c = bit::any_cutter();
  c.wear = *rc::gen::element(0.0, 0.5e-3, 2e-3);
  bit::CutterMeshing meshing;
  meshing.rim_segments = *battery::integer(8, 64);
  std::vector<bit::Part> parts = bit::cutter_parts(c, meshing);
  for (bit::Part& part : parts) part.cutter = 3;
  const FaceOutline face = face_outline(c, 3, parts);
  double farthest = -1.0, nearest = 1.0;
  const double area = moments(face.rim_F).area;
  for (const Vec2& x_F : face.rim_F) {
    const Vec3 x_B = face.X_BF * Vec3(0.0, x_F.x(), x_F.y());
    RC_ASSERT(x_F.norm() <= 0.5 * c.diameter * (1.0 + rounding));
    nearest = std::min(nearest, (x_B - bit::tip_B(c)).norm());
    farthest = std::max(farthest, bit::profile_normal_B(c).dot(x_B - bit::tip_B(c)));
  }
  RC_ASSERT(area > 0.0);
  if (c.wear > 0.0) RC_ASSERT(std::abs(farthest + c.wear) <= rounding);
  if (c.wear == 0.0) RC_ASSERT(nearest <= rounding);
}

/// A trapezoid in two triangles, by hand; a corner that was taken away leaves nothing.
TEST(Moments, are_those_of_the_corners_that_are_there) {
  ConvexPolygon trapezoid{{1.0, 1.0}, {4.0, 1.0}, {3.0, 3.0}, {1.0, 3.0}, {0.0, 9.0}};
  trapezoid.pop_back();
  const PolygonMoments m = moments(trapezoid);
  EXPECT_NEAR(m.area, 5.0, rounding);
  EXPECT_LT((m.moment - Vec2(3.0 * 8.0 / 3.0 + 2.0 * 5.0 / 3.0, 3.0 * 5.0 / 3.0 + 2.0 * 7.0 / 3.0))
                .norm(),
            rounding);
}

/// What a half-plane keeps and what its complement keeps are the whole, in any unit of length.
RC_GTEST_PROP(Clip, divides_a_polygon_into_two_that_make_it_up, ()) {
  const double size = std::ldexp(1.0, *battery::integer(-10, 10));
  ConvexPolygon polygon, inside, outside;
  const int corners = *battery::integer(3, 12);
  for (int k = 0; k < corners; ++k)
    polygon.push_back(size * Vec2(std::cos(k * 6.28 / corners), std::sin(k * 6.28 / corners)));
  const double angle = *battery::number(0.0, 6.28);
  const HalfPlane h{*battery::number(0.1, 9.0) * Vec2(std::cos(angle), std::sin(angle)),
                    size * *battery::number(-2.0, 2.0)};
  clip(polygon, h, inside);
  clip(polygon, {-h.n, -h.b}, outside);
  const PolygonMoments all = moments(polygon), in = moments(inside), out = moments(outside);
  RC_ASSERT(std::abs(in.area + out.area - all.area) <= rounding * size * size);
  RC_ASSERT((in.moment + out.moment - all.moment).norm() <= rounding * std::pow(size, 3));
  for (const Vec2& x : inside) RC_ASSERT(h.n.dot(x) - h.b <= rounding * size * 9.0);
  RC_ASSERT(in.area >= 0.0 && out.area >= 0.0);
}

TEST(FaceOutline, is_empty_without_parts) {
  EXPECT_TRUE(face_outline(bit::Cutter{}, 0, {}).rim_F.empty());
}

}  // namespace tdbd::rock::face_outline_test
