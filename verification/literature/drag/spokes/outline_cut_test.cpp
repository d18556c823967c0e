#include "reference/literature/drag/spokes/outline_cut.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "reference/literature/drag/spokes/rim_polygon.hpp"
#include "reference/literature/surface/planar_boolean.hpp"

namespace tdbd::reference::outline_cut_test {
namespace {

constexpr double mm = 1e-3;
const SpokeFrame frame{100 * mm, 60 * mm};

/// An integer share of a range, so that shrinking works.
double in_range(double lo, double hi) {
  return lo + (hi - lo) * *rc::gen::inRange(0, 100001) / 100000.0;
}

RimEllipse any_rim() {
  return {in_range(-4 * mm, 100 * mm), in_range(-8 * mm, 20 * mm), in_range(2 * mm, 9 * mm),
          in_range(2 * mm, 9 * mm), in_range(-1.0, 1.0)};
}

Outline tool_of(const RimEllipse& rim) {
  Outline tool;
  outline_of(rim_polygon(rim), tool);
  for (Vec2& x : tool) x = on_grid(x);
  return tool;
}

/// Many passes in one spoke: booleans of all, against crossings where there are two.
RC_GTEST_PROP(OutlineCut, leaves_what_booleans_leave, ()) {
  OutlineSpokes quick = flat_outline_spokes(frame, 0.0, 1, 0.5 * mm);
  PlanarRegion slow = quick.rock;
  const int passes = *rc::gen::inRange(1, 12);
  for (int pass = 0; pass < passes; ++pass) {
    const Outline tool = tool_of(any_rim());
    PlanarFace face = quick.rock.front();
    const double before = area({face});
    const double removed = before - area(without({face}, tool));
    if (cut_between_two_crossings(face, tool))
      RC_ASSERT(std::abs(before - area({face}) - removed) < 1e-10);  // m2: 2 nm along the rim
    cut_convex(quick, 0, tool);
  }
}

RC_GTEST_PROP(RimInFace, is_the_area_and_moment_of_the_common_part, ()) {
  OutlineSpokes rock = flat_outline_spokes(frame, 0.0, 1, 0.5 * mm);
  const int passes = *rc::gen::inRange(0, 8);
  for (int pass = 0; pass < passes; ++pass) cut_convex(rock, 0, tool_of(any_rim()));
  const RimEllipse rim = any_rim();
  const CrossingCut cut = rim_in_face(rim_polygon(rim), rock.rock.front());
  const PlanarRegion common = within(rock.rock, tool_of(rim));
  RC_ASSERT(std::abs(cut.area - area(common)) < 1e-10);  // m2: corners on the grid of 1 nm
  RC_ASSERT(std::abs(cut.moment - moment(common)) < 1e-11);
}

/// A rim whose middle is on a flat surface: its whole lower branch is in rock, and half of its area.
TEST(RimInFace, measures_the_edge_in_rock) {
  const OutlineSpokes rock = flat_outline_spokes(frame, 0.0, 1, 0.5 * mm);
  const double a = 8 * mm;
  const CrossingCut half = rim_in_face(rim_polygon({50 * mm, 0.0, a, a, 0.0}), rock.rock.front());
  EXPECT_NEAR(half.edge, M_PI * a, 5e-4 * M_PI * a);  // 32 chords: 4e-4 less
  EXPECT_NEAR(half.area, M_PI * a * a / 2.0, 2e-3 * half.area);
  EXPECT_NEAR(half.moment / half.area, 50 * mm, 1e-12);
}

}  // namespace
}  // namespace tdbd::reference::outline_cut_test
