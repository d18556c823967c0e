#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/tolerance.hpp"
#include "core/types.hpp"
#include "rock/cut/cut_rock.hpp"
#include "rock/section/contact_area.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/rock/cut/cutting_scene.hpp"

/// Parts that remove a share of the rock in their way. A part with the share s that passes over flat
/// rock at the depth d leaves a groove s d deep; the k-th pass leaves (1 - s)^k d above its path. Each
/// vertex has this exactly: it comes s of the way on which a part with the share 1 takes it.
namespace tdbd::rock::left_rock_test {
namespace {

constexpr double radius = 0.3, depth = 0.15, way = 1.2;

/// A disc that leans back by 20 degrees and moves along x, its lowest point `depth` below flat rock.
bit::Bit disc(double share) {
  bit::Part p;
  p.name = "disc";
  p.kind = bit::PartKind::face;
  p.mesh_P = battery::cylinder(radius, 0.25, 48);
  p.X_BP.R = Eigen::AngleAxisd(70.0 * degree, Vec3::UnitY()).toRotationMatrix();
  double lowest = 0.0;
  for (const Vec3& x_P : p.mesh_P.positions) lowest = std::max(lowest, (p.X_BP * x_P).z());
  p.X_BP.p.z() = depth - lowest;
  p.share = share;
  bit::Bit bit;
  bit.parts = {p};
  return bit;
}

/// Where the bit is at a share of its way.
Pose at_share(double a) {
  Pose X;
  X.p = Vec3((a - 0.5) * way, 0.0, 0.0);
  return X;
}

/// A rock that is cut, and what a step needs.
struct Cutter {
  Rock rock = make_rock(mesh::make_surface(battery::flat_rock(1.2, 0.0, 48)), 0.1, {});
  CuttingBit bit;
  CutWorkspace work;
  CutReport report;
  double removed = 0.0;

  explicit Cutter(double share) : bit(prepare_cutting_bit(disc(share))) {}

  void go(const Pose& from, const Pose& to) {
    cut_rock(rock, bit, from, to, work, report);
    removed += report.removed;
  }

  /// Down into the rock, along it, and out of it.
  void pass(int steps) {
    Pose above = at_share(0.0);
    above.p.z() = -2.0 * radius;
    for (int i = 0; i < steps; ++i)
      go(between(above, at_share(0.0), i, steps), between(above, at_share(0.0), i + 1, steps));
    for (int i = 0; i < steps; ++i) go(at_share(double(i) / steps), at_share((i + 1.0) / steps));
    Pose out = at_share(1.0);
    out.p.z() = -2.0 * radius;
    go(at_share(1.0), out);
    go(out, above);
  }

  static Pose between(const Pose& a, const Pose& b, int i, int n) {
    Pose X = a;
    X.p += double(i) / n * (b.p - a.p);
    return X;
  }

  double depth_of(int v) const { return rock.surface.position(v).z(); }
  double hole() const { return mesh::hole_volume(rock.surface, Vec3::Zero()); }
};

/// Far from both ends of the way, where the whole disc passes.
bool is_in_middle(const Cutter& c, int v) { return std::abs(c.rock.surface.position(v).x()) < 0.2; }

/// The largest difference of the depths in the middle from `share_of_all` of those of a part that
/// removes all, over the depth.
double difference(const Cutter& c, const Cutter& all, double share_of_all) {
  double worst = 0.0;
  for (int v = 0; v < c.rock.surface.vertex_slots(); ++v)
    if (is_in_middle(c, v))
      worst = std::max(worst, std::abs(c.depth_of(v) - share_of_all * all.depth_of(v)) / depth);
  return worst;
}

constexpr double rounding = 1e-13;

TEST(LeftRock, is_the_rest_of_the_depth_after_each_pass_whatever_the_step) {
  Cutter all(1.0);
  all.pass(40);
  double deepest = 0.0;
  for (int v = 0; v < all.rock.surface.vertex_slots(); ++v)
    deepest = std::max(deepest, all.depth_of(v));
  EXPECT_NEAR(deepest, depth, rounding * depth);
  for (const double share : {0.3, 0.7})
    for (const int steps : {20, 40, 80, 333}) {
      Cutter c(share);
      double left = 1.0;
      for (int k = 1; k <= 3; ++k) {
        c.pass(steps);
        left *= 1.0 - share;
        EXPECT_LT(difference(c, all, 1.0 - left), rounding)
            << "share " << share << ", " << steps << " steps, pass " << k;
        EXPECT_TRUE(c.rock.left.empty());
      }
      EXPECT_NEAR(c.removed, c.hole(), tolerance::ledger * c.hole());
    }
}

/// As long as the rock that is left is inside the part it is one pass, back and forth: behind the
/// lower edge for (1 - s) z / tan(20 degrees) of the way, 0.15 at z = 0.75 d.
TEST(LeftRock, is_not_cut_again_by_a_part_that_goes_back_and_forth) {
  Cutter all(1.0), c(0.5);
  all.pass(40);
  Pose above = at_share(0.0);
  above.p.z() = -2.0 * radius;
  c.go(above, at_share(0.0));
  const auto go = [&](double from, double to) {
    for (int i = 0; i < 20; ++i)
      c.go(at_share(from + i * (to - from) / 20), at_share(from + (i + 1) * (to - from) / 20));
  };
  go(0.0, 0.5);
  for (int i = 0; i < 10; ++i) {
    go(0.5, 0.47);
    go(0.47, 0.5);
  }
  const bit::Part part = disc(0.5).parts.front();
  double edge = 0.0;  // x of the lowest point
  for (const Vec3& x_P : part.mesh_P.positions)
    if (const Vec3 x = part.X_BP * x_P; x.z() > depth - 1e-9) edge = std::max(edge, x.x());
  int passed = 0;
  for (int v = 0; v < c.rock.surface.vertex_slots(); ++v) {
    const double behind = edge - c.rock.surface.position(v).x();
    if (behind < 0.04 || behind > 0.14 || all.depth_of(v) < 0.75 * depth) continue;
    ++passed;
    EXPECT_NEAR(c.depth_of(v), 0.5 * all.depth_of(v), rounding * depth);
  }
  EXPECT_GT(passed, 8);
}

/// One step from rock that no part is inside.
RC_GTEST_PROP(LeftRock, of_one_step_is_the_rest_of_each_move, ()) {
  Scene s = *scene({.most_parts = 1});
  const double share = *rc::gen::elementOf(std::vector<double>{0.1, 0.5, 0.9});
  Rock all = rock_of(s), some = all;
  CutWorkspace work, work_some;
  CutReport report, report_some;
  cut_rock(all, prepare_cutting_bit(s.bit), s.X_WB0, s.X_WB1, work, report);
  const Rock before = some;
  s.bit.parts.front().share = share;
  cut_rock(some, prepare_cutting_bit(s.bit), s.X_WB0, s.X_WB1, work_some, report_some);
  for (int v = 0; v < all.surface.vertex_slots(); ++v) {
    const Vec3 x = before.surface.position(v);
    const Vec3 d = share * (all.surface.position(v) - x);
    RC_ASSERT((some.surface.position(v) - x - d).norm() < 1e-14);
  }
  const double gained = mesh::hole_volume(some.surface, Vec3::Zero()) -
                        mesh::hole_volume(before.surface, Vec3::Zero());
  RC_ASSERT(std::abs(gained - report_some.removed) < 27.0 * tolerance::ledger);
}

/// The places at which the groups see the vertices come and go without a trace.
TEST(LeftRock, is_put_back_bitwise) {
  Cutter c(0.4);
  c.go(at_share(0.0), at_share(0.05));
  c.go(at_share(0.05), at_share(0.1));
  ASSERT_FALSE(c.rock.left.empty());
  const mesh::Surface before = c.rock.surface;
  std::vector<Vec3> places;
  apply_residues(c.rock, places);
  int moved = 0;
  for (int v = 0; v < before.vertex_slots(); ++v)
    moved += before.position(v) != c.rock.surface.position(v);
  EXPECT_EQ(moved, static_cast<int>(c.rock.left.size()));
  undo_residues(c.rock, places);
  for (int v = 0; v < before.vertex_slots(); ++v)
    EXPECT_EQ(before.position(v), c.rock.surface.position(v));
}

/// Per step, the contact of a block that goes down into flat rock and slides along it.
std::vector<PartContact> contacts_of_block(double share) {
  bit::Bit block;
  block.parts.emplace_back();
  block.parts.front().mesh_P = battery::box({-0.31, -0.23, -0.5}, {0.31, 0.23, 0.0});
  block.parts.front().share = share;
  Rock rock = make_rock(mesh::make_surface(battery::flat_rock(1.2, 0.0, 48)), 0.1, {});
  const CuttingBit bit = prepare_cutting_bit(block);
  CutWorkspace work;
  work.contact_gap = 5e-4;
  CutReport report;
  ContactWork contact;
  std::vector<PartContact> by_part, all;
  Pose X;
  X.p.z() = -0.01;
  for (int i = 0; i < 30; ++i) {
    Pose next = X;
    next.p += i < 15 ? Vec3(0.0, 0.0, 0.004) : Vec3(0.01, 0.0, 0.001);
    cut_rock(rock, bit, X, next, work, report);
    contact_areas(rock, bit, work, {work.contact_gap, {}}, contact, by_part);
    all.push_back(by_part.front());
    X = next;
  }
  return all;
}

/// It bears on the surface that it would leave if it removed all.
TEST(LeftRock, is_not_borne_on) {
  const std::vector<PartContact> all = contacts_of_block(1.0), some = contacts_of_block(0.4);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(whole(some[i]).area, whole(all[i]).area, 1e-13) << i;
    EXPECT_LT((whole(some[i]).centroid_W - whole(all[i]).centroid_W).norm(), 1e-13) << i;
  }
  EXPECT_NEAR(whole(all[10]).area, 0.62 * 0.46, 1e-3);
}

/// The deepest vertex in the middle after a pass of two such parts in one place, each with the share
/// 0.3, over the depth.
double after_two(int steps) {
  bit::Bit two = disc(0.3);
  two.parts.push_back(two.parts.front());
  Rock rock = make_rock(mesh::make_surface(battery::flat_rock(1.2, 0.0, 48)), 0.1, {});
  const CuttingBit bit = prepare_cutting_bit(two);
  EXPECT_EQ(bit.groups.size(), 2U);
  CutWorkspace work;
  CutReport report;
  Pose above = at_share(0.0);
  above.p.z() = -2.0 * radius;
  cut_rock(rock, bit, above, at_share(0.0), work, report);
  for (int i = 0; i < steps; ++i)
    cut_rock(rock, bit, at_share(static_cast<double>(i) / steps), at_share((i + 1.0) / steps), work,
             report);
  double deepest = 0.0;
  for (int v = 0; v < rock.surface.vertex_slots(); ++v)
    if (std::abs(rock.surface.position(v).x()) < 0.2)
      deepest = std::max(deepest, rock.surface.position(v).z());
  return deepest / depth;
}

/// Of rock in which two parts are at once each removes its share: of one step the second part takes
/// 0.3 of what the first has left, which is an error of first order in the step.
TEST(LeftRock, of_two_parts_in_the_same_rock_lacks_the_share_of_each) {
  const double coarse = after_two(400) - 0.6, fine = after_two(1600) - 0.6;
  EXPECT_LT(std::abs(fine), 0.01);
  EXPECT_LT(std::abs(fine), 0.5 * std::abs(coarse));
}

}  // namespace
}  // namespace tdbd::rock::left_rock_test
