#include "forces/laws/glowka.hpp"

#include <gtest/gtest.h>

#include "forces/fits.hpp"
#include "forces/generate.hpp"
#include "forces/laws/virgin_groove.hpp"

namespace tdbd::forces::glowka_test {

constexpr double inch = 25.4e-3, lbf = 4.4482216152605;

/// The 0.5 in cutter in Berea sandstone (Glowka 1989).
PartCut cutter_j(double area) {
  PartCut c = plain_cut(bit::PartKind::face);
  c.diameter = 0.5 * inch;
  c.cut_area = area;
  return c;
}

Glowka berea() {
  Glowka law = std::get<Glowka>(fit_named("glowka-berea-0.5in").law);
  law.slip_speed = 0.0;
  return law;
}

struct Row {
  double share, depth, normal, drag;  // 1, in, lbf, lbf
};

/// Whole, half and quarter of the groove of 0.06 in; printed to five digits: half of the last.
TEST(Glowka, on_the_effective_depth_is_that_of_the_literature) {
  const double whole = groove_area({0.5 * inch, 20 * degree}, 0.06 * inch);
  EXPECT_NEAR(whole, 0.01373336 * inch * inch, 1e-8 * inch * inch);
  for (const Row& r : {Row{1.0, 0.06, 87.079, 104.924},
                       {0.5, 0.0374094, 42.871, 53.393},
                       {0.25, 0.0234203, 21.236, 27.330}}) {
    const PartCut c = cutter_j(r.share * whole);
    EXPECT_NEAR(groove_depth({c.diameter, c.back_rake}, c.cut_area).depth, r.depth * inch,
                5e-8 * inch);
    const PartForce f = law_force(berea(), c);
    EXPECT_NEAR(f.normal, r.normal * lbf, 1e-3 * lbf);
    EXPECT_NEAR(f.tangential, r.drag * lbf, 5e-4 * lbf);
  }
}

/// Twice the depth of a groove: 2^1.5 times the normal force, 2^1.43 the drag.
TEST(Glowka, grows_with_its_powers_of_the_depth) {
  const GrooveCutter cutter{0.5 * inch, 20 * degree};
  const PartForce once = law_force(berea(), cutter_j(groove_area(cutter, 1e-3)));
  const PartForce twice = law_force(berea(), cutter_j(groove_area(cutter, 2e-3)));
  EXPECT_NEAR(once.normal, berea().Cn, 1e-12 * once.normal);
  EXPECT_NEAR(twice.normal, std::pow(2.0, 1.50) * once.normal, 1e-12 * twice.normal);
  EXPECT_NEAR(twice.tangential, std::pow(2.0, 1.43) * once.tangential, 1e-12 * twice.tangential);
}

TEST(Glowka, needs_the_diameter_and_says_so) {
  EXPECT_EQ(law_problem(Glowka{}, bit::PartKind::face, 0.0),
            "the law \"glowka\" needs the cutter's diameter, which this face has not");
  EXPECT_EQ(law_problem(Glowka{}, bit::PartKind::face, 13e-3), "");
  PartCut c = cutter_j(1e-6);
  c.diameter = 0.0;
  EXPECT_EQ(law_force(berea(), c).force, Vec3::Zero());
}

}  // namespace tdbd::forces::glowka_test
