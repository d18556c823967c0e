#include "rock/cut/cut_rock.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "core/tolerance.hpp"
#include "reference/rock/brute_force_exit.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/rock/cut/cutting_scene.hpp"

namespace tdbd::rock::cut_rock_test {

/// The rock before and after one step.
struct Cut {
  Rock before, after;
  CuttingBit bit;
  CutReport report;

  bool moved(int v) const { return before.surface.position(v) != after.surface.position(v); }
  Vec3 displacement(int v) const { return after.surface.position(v) - before.surface.position(v); }
};

Cut cut(const Scene& s) {
  Cut c;
  c.before = rock_of(s);
  c.after = c.before;
  c.bit = prepare_cutting_bit(s.bit);
  CutWorkspace work;
  cut_rock(c.after, c.bit, s.X_WB0, s.X_WB1, work, c.report);
  return c;
}

RelativePath path_past(const bit::Part& p, const Scene& s, const Vec3& x_W) {
  return {inverse(s.X_WB0 * p.X_BP) * x_W, inverse(s.X_WB1 * p.X_BP) * x_W, {}, {}};
}

constexpr int substeps = 32;

/// The deepest that a resting vertex gets into a part, at the twin's sub-poses.
double deepest(const bit::Part& p, const Scene& s, const Vec3& x_W) {
  const RelativePath r = path_past(p, s, x_W);
  double depth = -1e300;
  for (int k = 0; k <= substeps; ++k) {
    const double tau = static_cast<double>(k) / substeps;
    const Vec3 x_P = (1.0 - tau) * r.q0_P + tau * r.q1_P;
    depth = std::max(depth, depth_behind_triangles(p.mesh_P, x_P));
  }
  return depth;
}

/// Between two sub-poses a vertex gets at most this much deeper.
double resolution(const bit::Part& p, const Scene& s, const Vec3& x_W) {
  const RelativePath r = path_past(p, s, x_W);
  return 0.5 * (r.q1_P - r.q0_P).norm() / substeps;
}

/// Scale of the ledger: the cube over the rock's square.
constexpr double scale = 27.0;

RC_GTEST_PROP(CutRock, closes_the_ledger, ()) {
  const Cut c = cut(*scene());
  const double gained = mesh::hole_volume(c.after.surface, Vec3::Zero()) -
                        mesh::hole_volume(c.before.surface, Vec3::Zero());
  RC_TAG(c.report.moved > 0 ? "cuts" : "misses");
  RC_ASSERT(std::abs(gained - c.report.removed) < tolerance::ledger * scale);
  const auto& parts = c.report.removed_by_part;
  const double sum = std::accumulate(parts.begin(), parts.end(), 0.0);
  RC_ASSERT(std::abs(sum - c.report.removed) < tolerance::ledger * scale);
}

RC_GTEST_PROP(CutRock, leaves_no_vertex_inside_a_part_at_the_end, ()) {
  const Scene s = *scene();
  const Cut c = cut(s);
  RC_TAG(c.report.passes);
  for (const bit::Part& p : s.bit.parts)
    for (const Vec3& x_W : mesh::positions_of(c.after.surface)) {
      const Vec3 x_P = inverse(s.X_WB1 * p.X_BP) * x_W;
      RC_ASSERT(depth_behind_triangles(p.mesh_P, x_P) < tolerance::inside * c.bit.size);
    }
}

RC_GTEST_PROP(CutRock, moves_nothing_but_what_was_swept, ()) {
  const Scene s = *scene();
  const Cut c = cut(s);
  for (int v = 0; v < c.before.surface.vertex_slots(); ++v) {
    const Vec3& x_W = c.before.surface.position(v);
    const bool reached = std::any_of(s.bit.parts.begin(), s.bit.parts.end(), [&](const auto& p) {
      return deepest(p, s, x_W) > -resolution(p, s, x_W);
    });
    if (c.moved(v)) RC_ASSERT(reached);
  }
}

RC_GTEST_PROP(CutRock, moves_all_that_the_twin_finds_swept, ()) {
  const Scene s = *scene();
  const Cut c = cut(s);
  for (int v = 0; v < c.before.surface.vertex_slots(); ++v)
    for (const bit::Part& p : s.bit.parts) {
      const Vec3& x_W = c.before.surface.position(v);
      if (c.moved(v) || deepest(p, s, x_W) < 1e-9) continue;
      const RelativePath r = path_past(p, s, x_W);
      const Vec3 u(0, 0, 1);
      RC_ASSERT(!reference::brute_force_exit(p.mesh_P, r.q0_P, r.q1_P, u, u, substeps).swept);
    }
}

RC_GTEST_PROP(CutRock, keeps_connectivity_and_boundary_and_notes_who_cut, ()) {
  const Scene s = *scene();
  const Cut c = cut(s);
  RC_ASSERT(c.after.surface.triangles == c.before.surface.triangles);
  RC_ASSERT(c.after.surface.opposite == c.before.surface.opposite);
  for (int v = 0; v < c.before.surface.vertex_slots(); ++v) {
    if (c.before.surface.is_boundary(v)) RC_ASSERT(!c.moved(v));
    RC_ASSERT((c.after.last_part[v] >= 0) == c.moved(v));
    RC_ASSERT((c.after.touched[v] != 0) == c.moved(v));
  }
}

/// The mapped direction of a part at x (4.1.2.3): its update direction turned about the bit's axis
/// to the azimuth of x.
Vec3 mapped_W(const bit::Part& p, const Scene& s, const Vec3& x_W) {
  const Vec3 x_B = inverse(s.X_WB1) * x_W;
  const double azimuth = std::atan2(x_B.y(), x_B.x());
  const Mat3 turn = Eigen::AngleAxisd(azimuth, Vec3::UnitZ()).toRotationMatrix();
  return s.X_WB1.R * turn * p.update_direction_B;
}

RC_GTEST_PROP(CutRock, moves_along_the_mapped_direction_to_the_twins_exit, ()) {
  const Scene s = *scene({.most_parts = 1});
  const Cut c = cut(s);
  const bit::Part& p = s.bit.parts.front();
  const Mat3 R0 = inverse(s.X_WB0 * p.X_BP).R, R1 = inverse(s.X_WB1 * p.X_BP).R;
  for (int v = 0; v < c.before.surface.vertex_slots(); ++v) {
    if (!c.moved(v)) continue;
    const Vec3& x_W = c.before.surface.position(v);
    const Vec3 u_W = mapped_W(p, s, x_W);
    const double t = c.displacement(v).dot(u_W);
    RC_ASSERT(t > 0.0);
    RC_ASSERT((c.displacement(v) - t * u_W).norm() < 1e-14);
    const RelativePath r = path_past(p, s, x_W);
    const double twin =
        reference::brute_force_exit(p.mesh_P, r.q0_P, r.q1_P, R0 * u_W, R1 * u_W, substeps).t;
    RC_ASSERT(t > twin - 1e-3);
  }
}

/// Several parts and passes: every move is along a mapped direction, so all lie in the half-plane
/// through the bit's axis that the vertex is in, and none goes up or towards the axis.
RC_GTEST_PROP(CutRock, never_moves_up_or_inwards, ()) {
  const Scene s = *scene();
  const Cut c = cut(s);
  for (int v = 0; v < c.before.surface.vertex_slots(); ++v) {
    const Vec3 x_B = inverse(s.X_WB1) * c.before.surface.position(v);
    const double rho = std::hypot(x_B.x(), x_B.y());
    if (!c.moved(v) || rho == 0.0) continue;
    const Vec3 d_B = inverse(s.X_WB1).rotate(c.displacement(v));
    const Vec3 radial(x_B.x() / rho, x_B.y() / rho, 0.0), around(-radial.y(), radial.x(), 0.0);
    RC_ASSERT(std::abs(d_B.dot(around)) < 1e-13);
    RC_ASSERT(d_B.dot(radial) > -1e-14);
    RC_ASSERT(d_B.z() > -1e-14);
  }
}

/// Straight down over rock that is the graph of a function: no part can add any.
RC_GTEST_PROP(CutRock, straight_down_adds_no_rock_in_any_part, ()) {
  const Cut c = cut(*scene({.tilt = 0.0, .outwards = 0.0}));
  for (const double removed : c.report.removed_by_part)
    RC_ASSERT(removed >= -tolerance::ledger * scale);
}

bool same_bits(const Rock& a, const Rock& b) {
  return mesh::positions_of(a.surface) == mesh::positions_of(b.surface) &&
         a.last_part == b.last_part;
}

RC_GTEST_PROP(CutRock, twice_gives_the_same_bits_also_in_a_used_workspace, ()) {
  const Scene s = *scene(), other = *scene();
  const Cut once = cut(s);
  CutWorkspace used;
  CutReport report;
  Rock warm = rock_of(other);
  cut_rock(warm, prepare_cutting_bit(other.bit), other.X_WB0, other.X_WB1, used, report);
  Rock again = rock_of(s);
  cut_rock(again, once.bit, s.X_WB0, s.X_WB1, used, report);
  RC_ASSERT(same_bits(again, once.after));
  RC_ASSERT(report.removed_by_part == once.report.removed_by_part);
  RC_ASSERT(report.removed == once.report.removed);
}

/// A group that has left the rock moves nothing, though its workspace still knew what it moved before.
TEST(CutRock, moves_nothing_far_above_the_rock) {
  bit::Bit bit;
  bit.parts.push_back({});
  bit.parts.back().mesh_P = battery::box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.1});
  const CuttingBit cutting = prepare_cutting_bit(bit);
  const mesh::TriangleMesh sheet = battery::bumpy_rock(1.5, 10, 0.1, 7);
  Rock rock = make_rock(mesh::make_surface(sheet), 0.5, {Vec3(-2, -2, -9), Vec3(2, 2, 9)});
  const auto at_height = [](double z) { return Pose{Mat3::Identity(), Vec3(0, 0, z)}; };
  CutWorkspace work;
  CutReport report;
  cut_rock(rock, cutting, at_height(-0.5), at_height(0.0), work, report);
  ASSERT_GT(report.moved, 0);
  cut_rock(rock, cutting, at_height(-7.0), at_height(-7.1), work, report);
  EXPECT_EQ(report.moved, 0);
}

/// A vertex's path depends on the vertex alone: renumbered rock goes to the same places, bit for
/// bit; only the order of the volumes' sums changes.
RC_GTEST_PROP(CutRock, does_not_depend_on_the_numbering_of_the_rock, ()) {
  Scene s = *scene();
  const Cut c = cut(s);
  const int n = static_cast<int>(s.rock_W.positions.size());
  std::reverse(s.rock_W.positions.begin(), s.rock_W.positions.end());
  for (mesh::Triangle& t : s.rock_W.triangles)
    for (int& v : t) v = n - 1 - v;
  std::reverse(s.rock_W.triangles.begin(), s.rock_W.triangles.end());
  const Cut r = cut(s);
  for (int v = 0; v < n; ++v) {
    RC_ASSERT(r.after.surface.position(n - 1 - v) == c.after.surface.position(v));
    RC_ASSERT(r.after.last_part[n - 1 - v] == c.after.last_part[v]);
  }
  for (std::size_t i = 0; i < c.report.removed_by_part.size(); ++i)
    RC_ASSERT(std::abs(r.report.removed_by_part[i] - c.report.removed_by_part[i]) < 1e-15 * scale);
}

/// After every step the list of a group contains every vertex of its region with its position and
/// has recorded every change, so that the next step can reuse it.
RC_GTEST_PROP(CutRock, updates_the_near_lists, ()) {
  const Scene s = *scene();
  const CuttingBit bit = prepare_cutting_bit(s.bit);
  Rock rock = rock_of(s);
  CutWorkspace work;
  CutReport report;
  const Pose motion = inverse(s.X_WB0) * s.X_WB1;
  Pose X_WB = s.X_WB0;
  for (int step = 0; step < 3; ++step, X_WB = X_WB * motion) {
    cut_rock(rock, bit, X_WB, X_WB * motion, work, report);
    for (const NearList& list : rock.near_lists) {
      if (list.v.empty()) continue;
      RC_ASSERT(list.changes == rock.grid.changes());
      for (int v = 0; v < rock.surface.vertex_slots(); ++v) {
        const Vec3& x_W = rock.surface.position(v);
        if (!is_between(list.region_W.slabs, x_W)) continue;
        const auto i = static_cast<std::size_t>(std::ranges::find(list.v, v) - list.v.begin());
        RC_ASSERT(i < list.v.size());
        const Vec3 place_W = list.origin_W + Vec3(list.x[i], list.y[i], list.z[i]);
        RC_ASSERT((place_W - x_W).norm() < single_slack(list.region_W.box));
      }
    }
  }
}

/// The size of the index's cells decides in which order vertices are found, and nothing else.
RC_GTEST_PROP(CutRock, does_not_depend_on_the_index, ()) {
  const Scene s = *scene();
  const Cut c = cut(s);
  Rock rock = make_rock(mesh::make_surface(s.rock_W), *battery::number(0.05, 3.0), {});
  CutWorkspace work;
  CutReport report;
  cut_rock(rock, c.bit, s.X_WB0, s.X_WB1, work, report);
  RC_ASSERT(same_bits(rock, c.after));
  RC_ASSERT(report.removed_by_part == c.report.removed_by_part);
}

/// The same step again: everything is outside already.
RC_GTEST_PROP(CutRock, of_a_bit_that_rests_finds_nothing_left, ()) {
  const Scene s = *scene();
  Cut c = cut(s);
  CutWorkspace work;
  const Rock after = c.after;
  cut_rock(c.after, c.bit, s.X_WB1, s.X_WB1, work, c.report);
  for (int v = 0; v < after.surface.vertex_slots(); ++v) {
    const double moved = (c.after.surface.position(v) - after.surface.position(v)).norm();
    RC_ASSERT(moved < tolerance::inside * c.bit.size);
  }
}

Scene plate_over(double x) {
  Scene s;
  bit::Part p;
  p.name = "plate-7";
  p.mesh_P = battery::box({-0.2, -0.2, -0.2}, {0.2, 0.2, 0.2});
  s.bit.parts = {p};
  s.X_WB0.p = s.X_WB1.p = Vec3(x, 0, 0);
  s.rock_W = battery::flat_rock(1.0, 0.0, 10);
  return s;
}

TEST(CutRock, that_sweeps_the_boundary_is_an_error_with_the_parts_name) {
  EXPECT_NO_THROW(cut(plate_over(0.7)));
  try {
    cut(plate_over(0.9));
    FAIL() << "accepted";
  } catch (const RunError& e) {
    EXPECT_NE(std::string(e.what()).find("plate-7"), std::string::npos) << e.what();
  }
}

/// A block of which one face has the given normal (in the bit's X-Z plane) and goes through x.
bit::Part block_behind(const Vec3& normal, const Vec3& x, const Vec3& direction) {
  bit::Part p;
  p.mesh_P = battery::box({-0.3, -0.3, -0.6}, {0.3, 0.3, 0.0});
  p.X_BP = {Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), normal).toRotationMatrix(), x};
  p.update_direction_B = direction;
  return p;
}

/// Two blocks overlap; each pushes rock vertices back into the other, by 0.77 times the way of the
/// push before: a zigzag into the corner between them, about 100 moves to the tolerance.
TEST(CutRock, follows_a_zigzag_between_two_parts_to_its_end) {
  Scene s;
  const Vec3 corner(0.5, 0, 0.1);
  const Vec3 outwards = Vec3(std::sin(1.4), 0, std::cos(1.4));
  s.bit.parts = {block_behind(Vec3(-1, 0, 1).normalized(), corner, Vec3::UnitZ()),
                 block_behind(Vec3(1, 0, -0.8).normalized(), corner, outwards)};
  s.rock_W = battery::flat_rock(2.0, 0.0, 80);
  const Cut c = cut(s);
  EXPECT_GT(c.report.passes, 32);
  for (const bit::Part& p : s.bit.parts)
    for (const Vec3& x_W : mesh::positions_of(c.after.surface))
      EXPECT_LT(depth_behind_triangles(p.mesh_P, inverse(p.X_BP) * x_W),
                tolerance::inside * c.bit.size);
}

TEST(CutRock, skips_parts_that_never_cut) {
  Scene s = plate_over(0.0);
  s.bit.parts.front().cutting = bit::Cutting::never;
  s.bit.parts.push_back(s.bit.parts.front());
  s.bit.parts.back().cutting = bit::Cutting::cuts;
  s.bit.parts.back().X_BP.p = Vec3(0.5, 0, 0);
  const Cut c = cut(s);
  EXPECT_EQ(c.report.removed_by_part[0], 0.0);
  EXPECT_GT(c.report.removed_by_part[1], 0.0);
}

}  // namespace tdbd::rock::cut_rock_test
