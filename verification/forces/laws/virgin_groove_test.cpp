#include "forces/laws/virgin_groove.hpp"

#include <gtest/gtest.h>

#include "forces/generate.hpp"
#include "reference/forces/groove_by_strips.hpp"

namespace tdbd::forces::virgin_groove_test {

/// By hand: a 16 mm face cut at 0.5, 1, 2 mm in its plane; printed to seven digits.
TEST(GrooveArea, is_that_of_the_literature) {
  const GrooveCutter c{.diameter = 16e-3, .back_rake = 20 * degree};
  const double lean = std::cos(c.back_rake);
  for (const auto& [y, segment] : {std::pair{0.5, 1.867841}, {1.0, 5.232189}, {2.0, 14.505976}})
    EXPECT_NEAR(groove_area(c, y * 1e-3 * lean), segment * 1e-6 * lean, 5e-7 * 1e-6) << y;
}

/// Strips of a half circle's end are off by their width to the power 1.5: 1e-5 of the face here.
RC_GTEST_PROP(GrooveArea, is_that_of_strips, ()) {
  const GrooveCutter c{.diameter = number(8e-3, 25e-3), .back_rake = number(-0.3, 0.7)};
  const double depth = number(0.0, 1.2) * c.diameter;
  const double strips = reference::groove_area_by_strips(c.diameter, c.back_rake, depth, 2000);
  RC_ASSERT(std::abs(groove_area(c, depth) - strips) < 8e-6 * c.diameter * c.diameter);
}

/// Also where the difference of angle and chord would lose them: in 64 bits it does not, from 0.01 rad
/// on. The angle itself is known to some ulp, its cube to 16.
RC_GTEST_PROP(GrooveArea, has_all_its_digits, ()) {
  const GrooveCutter c{.diameter = number(8e-3, 25e-3), .back_rake = number(-0.3, 0.7)};
  const double a = c.diameter / 2.0, lean = std::cos(c.back_rake), half = number(0.01, 0.299);
  const double depth = 2.0 * a * lean * std::pow(std::sin(half / 2.0), 2);
  const long double t =
      2.0L * std::asin(std::sqrt(static_cast<long double>(depth) / (2.0L * a * lean)));
  const auto area = static_cast<double>((t - std::sin(t) * std::cos(t)) * a * a * lean);
  RC_ASSERT(std::abs(groove_area(c, depth) - area) <= rounding(area / 3.0));
}

/// Down to cuts of a billionth of the face, and up to all of it.
RC_GTEST_PROP(GrooveDepth, is_the_inverse_of_the_area, ()) {
  const GrooveCutter c{.diameter = number(8e-3, 25e-3), .back_rake = number(-0.3, 0.7)};
  const double face = pi / 4 * c.diameter * c.diameter * std::cos(c.back_rake);
  const double area = face * (index(2) == 0 ? number(0.0, 1.0) : std::pow(10.0, -number(0.0, 9.0)));
  const GrooveDepth g = groove_depth(c, area);
  // Near the whole face the depth loses digits as the root of the rest of the area.
  RC_ASSERT(std::abs(groove_area(c, g.depth) - area) <=
            rounding(face * (area > 0.9 * face)) + rounding(area));
  RC_ASSERT(g.iterations >= 1 || area == 0.0 || area >= (1.0 - 1e-15) * face);
  RC_ASSERT(g.iterations <= 5);
}

TEST(GrooveDepth, of_nothing_is_none_and_of_too_much_the_whole_face) {
  const GrooveCutter c{.diameter = 16e-3, .back_rake = 20 * degree};
  EXPECT_EQ(groove_depth(c, 0.0).depth, 0.0);
  EXPECT_EQ(groove_depth(c, 0.0).iterations, 0);
  EXPECT_NEAR(groove_depth(c, 1.0).depth, 16e-3 * std::cos(c.back_rake), 1e-17);
}

}  // namespace tdbd::forces::virgin_groove_test
