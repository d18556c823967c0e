#include "rock/cut/wide_exits.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <numbers>

#include "core/random.hpp"
#include "core/tolerance.hpp"
#include "rock/cut/cut_rock.hpp"
#include "rock/cut/swept_part.hpp"
#include "rotation/screw.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/rock/cut/cutting_scene.hpp"
#include "verification/rock/cut/round_solids.hpp"

namespace tdbd::rock::wide_exits_test {

/// A place on the solid's surface, where a ray from its axis leaves it.
Vec3 on_surface(const RoundSolid& s, Random& random) {
  const Vec3 from(0.0, 0.0, 0.0),
      way(random.uniform(-0.5, 0.5), random.uniform(-1, 1), random.uniform(-1, 1));
  double t = s.size;
  for (std::size_t i = 0; i < s.solid_P.planes; ++i) {
    const Vec3 n = mesh::normal(s.solid_P, i);
    if (n.dot(way) > 0.0) t = std::min(t, (s.solid_P.b[i] - n.dot(from)) / n.dot(way));
  }
  return from + t * way;
}

Vec3 any(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

Vec3 any_normal(const RoundSolid& s, Random& random) {
  const auto planes = static_cast<double>(s.solid_P.planes);
  return mesh::normal(s.solid_P, static_cast<std::size_t>(random.uniform(0.0, planes - 1.0)));
}

/// Paths near the surface, as rock has them, with a share of degenerate ones: at rest, along an axis
/// of the solid, into a plane's direction.
RelativePath any_path(const RoundSolid& s, Random& random) {
  const double length = std::pow(10.0, random.uniform(-4, -0.3));
  const Vec3 x = on_surface(s, random);
  const auto kind = static_cast<int>(random.uniform(0.0, 12.0));
  Vec3 way = length * any(random),
       u = Vec3(0.3 * any(random) + Vec3(0.0, x.y(), x.z())).normalized();
  Vec3 q0 = x + 0.5 * length * any(random);
  if (kind == 0) way = Vec3::Zero();
  if (kind == 1) way = -length * Vec3::UnitX();
  if (kind == 2) u = Vec3::UnitX();
  if (kind == 3) u = any_normal(s, random);
  if (kind == 4) u = u.cross(any(random)).normalized();
  if (kind == 5) q0 = 0.1 * any(random);
  if (kind == 6) q0 = x;
  const Vec3 u1 = Vec3(u + *rc::gen::element(0.0, 1e-3, 0.02) * any(random)).normalized();
  return {q0, q0 + way, u, kind % 2 == 0 ? u : u1};
}

/// A path as rock takes it past a cutter: along the axis, and out of the cutter away from it.
RelativePath drilling_path(const RoundSolid& s, Random& random) {
  const double length = std::pow(10.0, random.uniform(-3, -1));
  const Vec3 x = on_surface(s, random), radial(0.0, x.y(), x.z());
  const Vec3 way = length * (Vec3::UnitX() + 0.05 * any(random)),
             u = Vec3(0.3 * Vec3::UnitX() + radial.normalized()).normalized();
  const Vec3 q0 = x - random.uniform(0, 1) * length * Vec3::UnitX() - 0.05 * length * radial;
  return {q0, q0 + way, u, Vec3(u + 1e-3 * any(random)).normalized()};
}

void put(const RelativePath& p, std::size_t l, WidePaths& w) {
  const auto set = [l](const Vec3& x, WideVec3& to) {
    to.x[l] = x.x(), to.y[l] = x.y(), to.z[l] = x.z();
  };
  set(p.q0_P, w.q0), set(p.q1_P, w.q1), set(p.u0_P, w.u0), set(p.u1_P, w.u1);
}

/// Exits of four paths at once, and those of one after another.
struct Compared {
  int swept = 0, alone = 0;
};

/// Compares the exits of random paths, four at a time, bitwise with find_exit and all planes, where they
/// are known.
template <class AnyPath>
Compared compare(const RoundSolid& s, const PlaneSectors& sectors, int fours,
                 AnyPath&& any_path_of) {
  const double depth = tolerance::swept * s.size;
  PlaneStrip strip;
  Compared sum;
  for (int k = 0; k < fours; ++k) {
    std::array<RelativePath, lanes> paths;
    WidePaths wide{};
    for (std::size_t l = 0; l < lanes; ++l) put(paths[l] = any_path_of(k), l, wide);
    WideExits exits;
    find_exits(sectors, wide, depth, exits);
    for (std::size_t l = 0; l < lanes; ++l) {
      const auto x = find_exit(s.solid_P, paths[l], depth, strip);
      const bool missed = (exits.missed >> l & 1U) != 0, found = (exits.found >> l & 1U) != 0;
      RC_ASSERT(!missed || !found);
      if (missed) RC_ASSERT(!x);
      sum.swept += x ? 1 : 0;
      sum.alone += x && !found ? 1 : 0;
      if (!found) continue;
      RC_ASSERT(x.has_value());
      RC_ASSERT(x->t == exits.t[l]);
      RC_ASSERT(x->tau == exits.tau[l]);
      RC_ASSERT(x->plane == exits.sector[l]->plane[static_cast<std::size_t>(exits.row[l])]);
    }
  }
  return sum;
}

RC_GTEST_PROP(WideExits, are_those_of_one_vertex_after_another, ()) {
  const RoundSolid s = any_round_solid();
  const PlaneSectors sectors = plane_sectors(s.solid_P, s.size);
  if (sectors.sectors.empty()) return;
  Random random = battery::any_random();
  const Compared c = compare(s, sectors, 200, [&](int k) {
    return k % 2 == 0 ? any_path(s, random) : drilling_path(s, random);
  });
  RC_TAG(c.swept == 0 ? 0 : 10 * (10 * c.alone / c.swept));
}

/// Directions that are normal to a plane lead past the solid at one end of the step, far from where the
/// exit is: of ten thousand such paths one gets another exit if the search is not given up where the
/// planes of the sector are not enough.
RC_GTEST_PROP(WideExits, are_unknown_where_the_planes_of_a_sector_are_insufficient, ()) {
  const RoundSolid s = any_round_solid();
  const PlaneSectors sectors = plane_sectors(s.solid_P, s.size);
  if (sectors.sectors.empty()) return;
  Random random = battery::any_random();
  compare(s, sectors, 500, [&](int) {
    const double length = std::pow(10.0, random.uniform(-4, -0.5));
    const Vec3 q0 = on_surface(s, random) + 0.5 * length * any(random), u = any_normal(s, random);
    return RelativePath{q0, q0 + length * any(random), u, u};
  });
}

/// So that the test above is not about vertices that go alone.
RC_GTEST_PROP(WideExits, are_found_for_nearly_all_paths_of_drilling, ()) {
  const CuttingBit cutting = prepare_cutting_bit(any_cutter_bit());
  const CuttingGroup& g = cutting.groups.front();
  RC_ASSERT(g.whole->sectors != nullptr);
  Random random = battery::any_random();
  int swept = 0, alone = 0;
  for (int k = 0; k < 100; ++k) {
    WidePaths wide{};
    for (std::size_t l = 0; l < lanes; ++l)
      put(drilling_path({g.whole->solid.solid_P, 1.0}, random), l, wide);
    WideExits exits;
    find_exits(*g.whole->sectors, wide, g.whole->solid.depth, exits);
    swept += std::popcount(~exits.missed & 15U);
    alone += std::popcount(~(exits.missed | exits.found) & 15U);
  }
  RC_ASSERT(swept > 100);
  RC_ASSERT(10 * alone < swept);
}

/// Of a bit with many equal cutters, one has sectors.
TEST(WideExits, share_the_sectors_of_equal_cutters) {
  bit::Bit bit;
  for (int group = 0; group < 3; ++group)
    for (const double x : {0.0, 0.5}) {
      bit::Part p;
      p.group = group;
      p.mesh_P = battery::placed(
          {Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitY()).toRotationMatrix(),
           Vec3(x, 0.0, 0.0)},
          battery::cylinder(group < 2 ? 0.4 : 0.3, 0.5, 32));
      bit.parts.push_back(p);
    }
  const CuttingBit cutting = prepare_cutting_bit(bit);
  ASSERT_EQ(cutting.groups.size(), 3U);
  const auto sectors = [&](std::size_t i) { return cutting.groups[i].whole->sectors; };
  ASSERT_NE(sectors(0), nullptr);
  EXPECT_EQ(sectors(0), sectors(1));
  EXPECT_NE(sectors(0), sectors(2));
}

}  // namespace tdbd::rock::wide_exits_test

namespace tdbd::rock::swept_whole_test {

bit::Bit any_cutter() {
  return cutter_bit(*rc::gen::element(0.0, 0.05), *rc::gen::element(0.0, 0.03), 32);
}

RelativePath any_path() {
  const Vec3 q = 0.4 * *battery::point(1.0) - 0.2 * Vec3::UnitX(), u = *battery::direction();
  return {q, q + 0.2 * *battery::point(1.0), u, u};
}

/// Twin: out of one part after another until none sweeps it.
double exit_part_by_part(const CuttingGroup& g, RelativePath p) {
  SweptScratch scratch;
  double t = 0.0;
  for (bool moves = true; moves;) {
    moves = false;
    for (const CuttingPart& part : g.parts) {
      const double more = exit_distance(part, p, scratch).value_or(0.0);
      p.q0_P += more * p.u0_P;
      p.q1_P += more * p.u1_P;
      t += more;
      moves = moves || more > tolerance::inside;
    }
  }
  return t;
}

RC_GTEST_PROP(WholeExits, are_where_the_way_through_the_parts_ends, ()) {
  const bit::Bit bit = any_cutter();
  const CuttingBit cutting = prepare_cutting_bit(bit, {.exit_from = ExitFrom::whole});
  const CuttingGroup& g = cutting.groups.front();
  RC_ASSERT(g.whole.has_value());
  SweptScratch scratch;
  const RelativePath p = any_path();
  prepare_exits(g.whole->solid, boxes_around({p}, {0}), scratch);
  const auto x = prepared_union_exit(*g.whole, p, scratch);
  RC_TAG(x ? static_cast<int>(x->part) : -1);
  RC_ASSERT(std::abs((x ? x->t : 0.0) - exit_part_by_part(g, p)) < 1e-12);
  if (!x) return;
  double nearest = 1.0;  // some place of the level at the exit touches its owner
  for (int k = 0; k <= 1000; ++k) {
    const Vec3 x_P = p.q0_P + 1e-3 * k * (p.q1_P - p.q0_P) + x->t * p.u0_P;
    nearest = std::min(nearest, -depth_inside(g.parts[x->part], x_P));
  }
  RC_ASSERT(nearest < 1.5e-4);
}

struct Cut {
  Rock rock;
  CutReport report;
};

Cut cut(const Scene& s, ExitFrom from) {
  Cut c;
  c.rock = rock_of(s);
  CutWorkspace work;
  cut_rock(c.rock, prepare_cutting_bit(s.bit, {.exit_from = from}), s.X_WB0, s.X_WB1, work,
           c.report);
  return c;
}

Scene cutter_in_rock() {
  Scene s = *scene();
  s.bit = any_cutter();
  return s;
}

/// The cutter's volume is the same, its parts' shares are not; every vertex was last moved by the
/// same part, so that contact areas are the same.
RC_GTEST_PROP(WholeExits, leave_the_same_rock_volume_and_last_parts_as_part_by_part, ()) {
  const Scene s = cutter_in_rock();
  const Cut parts = cut(s, ExitFrom::parts), whole = cut(s, ExitFrom::whole);
  RC_TAG(whole.report.moved > 0 ? "cuts" : "misses");
  RC_ASSERT(whole.report.passes <= 2);
  RC_ASSERT(std::abs(whole.report.removed - parts.report.removed) < 1e-12);
  for (int v = 0; v < whole.rock.surface.vertex_slots(); ++v)
    RC_ASSERT((whole.rock.surface.position(v) - parts.rock.surface.position(v)).norm() < 1e-12);
  RC_ASSERT(whole.rock.last_part == parts.rock.last_part);
}

/// The contract of rock (5).
RC_GTEST_PROP(WholeExits, leave_no_vertex_inside_a_part, ()) {
  const Scene s = cutter_in_rock();
  const Cut c = cut(s, ExitFrom::whole);
  for (const bit::Part& p : s.bit.parts)
    for (const Vec3& x_W : mesh::positions_of(c.rock.surface)) {
      const Vec3 x_P = inverse(s.X_WB1 * p.X_BP) * x_W;
      RC_ASSERT(depth_behind_triangles(p.mesh_P, x_P) < tolerance::inside);
    }
}

}  // namespace tdbd::rock::swept_whole_test
