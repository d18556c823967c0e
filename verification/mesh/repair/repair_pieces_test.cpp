#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "mesh/check/self_intersections.hpp"
#include "mesh/check/weld.hpp"
#include "mesh/files/solids.hpp"
#include "mesh/measures.hpp"
#include "mesh/repair/repair.hpp"
#include "mesh/repair/repair_steps.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::mesh::repair_pieces_test {

const TriangleMesh ten = battery::box({0, 0, 0}, {10, 10, 10});

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  return merged({{"a", a}, {"b", b}});
}

TriangleMesh turned(TriangleMesh m) {
  for (Triangle& t : m.triangles) std::swap(t[1], t[2]);
  return m;
}

TriangleMesh moved(TriangleMesh m, const Vec3& by) {
  for (Vec3& x : m.positions) x += by;
  return m;
}

/// The same mesh with the facets of each piece in another order, so that another one is the first.
TriangleMesh beginning_with(TriangleMesh m, std::size_t first) {
  std::rotate(m.triangles.begin(), m.triangles.begin() + static_cast<std::ptrdiff_t>(first),
              m.triangles.end());
  return m;
}

void expect_volume(const Repaired& r, double volume, const std::string& what) {
  EXPECT_EQ(r.refusal, "") << what;
  EXPECT_TRUE(check_solid(r.mesh).empty()) << what << summarize(check_solid(r.mesh));
  EXPECT_NEAR(enclosed_volume(r.mesh), volume, 1e-5 * volume) << what;
}

/// Whatever the offset and the first facet, including walls that coincide.
TEST(RepairPieces, unites_overlapping_boxes_at_any_offset) {
  for (const Vec3& by : {Vec3(5, 2, 3), Vec3(5, 5, 5), Vec3(-9, 0.5, 0), Vec3(5, 0, 0),
                         Vec3(9.5, 9.5, 9.5), Vec3(0, 0, 4), Vec3(3, -7, 1)})
    for (const std::size_t first : {0u, 3u, 7u, 10u})
      for (const bool is_turned : {false, true}) {
        TriangleMesh other = beginning_with(moved(ten, by), first);
        if (is_turned) other = turned(other);
        const Vec3 common = (Vec3::Constant(10) - by.cwiseAbs()).cwiseMax(0.0);
        expect_volume(repair(joined(ten, other)), 2000 - common.prod(),
                      std::to_string(by.x()) + " " + std::to_string(first));
      }
}

/// A closed splinter that pokes out of a body, or lies in it, is united with it.
TEST(RepairPieces, unites_a_stray_splinter_with_the_body) {
  const TriangleMesh body = battery::sphere(10, 3);
  const double volume = enclosed_volume(body);
  for (const double reach : {2.0, 9.0, 9.9, 10.2}) {
    TriangleMesh splinter = battery::box({0, 0, 0}, {1, 1, 1});
    splinter = moved(splinter, Vec3(reach, 0.3, 0.2));
    for (const TriangleMesh& piece : {splinter, turned(splinter)}) {
      if (reach == 2.0 && enclosed_volume(piece) < 0.0) continue;  // a cavity
      for (const TriangleMesh& m : {joined(body, piece), joined(piece, body)}) {
        const Repaired r = check_solid(m).empty() ? Repaired{m, {}, {}} : repair(m);
        EXPECT_EQ(r.refusal, "") << reach;
        EXPECT_TRUE(check_solid(r.mesh).empty());
        EXPECT_GE(enclosed_volume(r.mesh), volume - 1e-9) << reach;
        EXPECT_LE(enclosed_volume(r.mesh), volume + 1.0 + 1e-9) << reach;
      }
    }
  }
}

/// A cavity survives a union of its body with another one.
TEST(RepairPieces, keeps_cavities_in_a_union) {
  const TriangleMesh hollow = joined(ten, turned(battery::box({2, 2, 2}, {4, 4, 4})));
  ASSERT_TRUE(check_solid(hollow).empty());
  expect_volume(repair(joined(hollow, battery::box({8, 3, 3}, {15, 7, 7}))), 1000 - 8 + 80, "");
}

/// Boxes in boxes, each either way round: the winding number decides what is solid.
RC_GTEST_PROP(RepairPieces, nested_ones_follow_the_winding_number, ()) {
  const int depth = *battery::integer(1, 5);
  TriangleMesh m;
  double expected = 0.0;
  int winding = 0, outermost = 0;
  for (int k = 0; k < depth; ++k) {
    const int sign = *rc::gen::arbitrary<bool>() ? 1 : -1;
    if (k == 0) outermost = sign;
    const double half = depth - k + 0.1 * k;
    const TriangleMesh box = battery::box(Vec3::Constant(-half), Vec3::Constant(half));
    const bool was_solid = winding > 0;
    winding += sign * outermost;
    if (was_solid != (winding > 0)) expected += (was_solid ? -8.0 : 8.0) * half * half * half;
    m = *rc::gen::arbitrary<bool>() ? joined(m, sign > 0 ? box : turned(box))
                                    : joined(sign > 0 ? box : turned(box), m);
  }
  orient_pieces(m);
  drop_inner_shells(m);
  RC_ASSERT(std::abs(enclosed_volume(m) - expected) < 1e-12 * expected);
  RC_ASSERT(check_solid(m).empty());
  RC_ASSERT(orient_pieces(m) == 0u);
  RC_ASSERT(drop_inner_shells(m) == 0u);
}

/// A body inside a body: found, and the union is the outer one.
TEST(RepairPieces, drops_a_body_inside_a_body) {
  const TriangleMesh m = joined(ten, battery::box({2, 2, 2}, {7, 7, 7}));
  const std::vector<Defect> defects = check_solid(m);
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(name(defects[0].kind), "piece that bounds nothing");
  EXPECT_NE(defects[0].where.find("12 facets with "), std::string::npos) << defects[0].where;
  EXPECT_NE(defects[0].where.find("1.25e+11 mm3, inside another piece"), std::string::npos)
      << defects[0].where;
  expect_volume(repair(m), 1000, "");
  EXPECT_EQ(repair(m).steps.at(0).count, 12u);
  EXPECT_FALSE(check_solid(joined(ten, turned(moved(ten, {20, 0, 0})))).empty())
      << "an inward piece beside the body";
}

/// Corners of one side lie on the edges of the other, any number of them and on either side.
TEST(RepairPieces, closes_t_junctions) {
  for (const int points : {1, 2, 5})
    for (const double off : {0.0, 1e-6}) {
      TriangleMesh m = ten;
      for (int k = 0; k < 12; k += 3) {  // each facet's first side gets corners of its own
        const Triangle t = m.triangles[at(k)];
        int from = t[0];
        const Vec3 a = position(m, t[0]), b = position(m, t[1]);
        m.triangles[at(k)] = {from, static_cast<int>(m.positions.size()), t[2]};
        for (int p = 1; p <= points; ++p) {
          const double s = (p + 0.01 * k) / (points + 1.0);
          const int v = static_cast<int>(m.positions.size());
          m.positions.push_back((1 - s) * a + s * b + Vec3::Constant(off));
          if (p > 1) m.triangles.push_back({from, v, t[2]});
          from = v;
        }
        m.triangles.push_back({from, t[1], t[2]});
      }
      ASSERT_FALSE(check_solid(m).empty());
      const Repaired r = repair(m);
      expect_volume(r, 1000, std::to_string(points));
      EXPECT_EQ(r.steps.at(0).what, "corners inserted into edges on which they lie (T-junctions)");
      EXPECT_EQ(r.steps.at(0).count, static_cast<std::size_t>(4 * points));
      EXPECT_EQ(r.steps.size(), 1u);
    }
}

/// Merging points that are far apart flattens a detail: refused, with the numbers.
TEST(RepairLoss, of_a_weld_that_is_too_long_is_refused) {
  const TriangleMesh sphere = battery::sphere(10, 2);
  EXPECT_EQ(repair(sphere, {1e-3}).refusal, "");
  const std::string refusal = repair(sphere, {4.0}).refusal;
  EXPECT_TRUE(refusal.starts_with("merging points would change its volume from ")) << refusal;
  EXPECT_NE(refusal.find("at most 1 % are permitted"), std::string::npos) << refusal;
}

/// A spike through the far side: remeshing cuts it off.
TEST(RepairLoss, of_a_spike_is_refused_with_the_numbers) {
  TriangleMesh m = battery::sphere(1, 2);
  m.positions[0] *= -1.3;
  const std::string refusal = repair(m).refusal;
  EXPECT_TRUE(refusal.starts_with("remeshing around intersections would change its ")) << refusal;
  EXPECT_NE(refusal.find(" %)"), std::string::npos) << refusal;
}

/// The missing corner of a box is a guess; a flat side is not.
TEST(RepairLoss, of_a_large_hole_that_is_not_flat_is_refused) {
  TriangleMesh m = ten, flat = ten;
  const auto is_on = [&](Eigen::Index axis) {
    return [&m, axis](const Triangle& t) {
      return std::ranges::all_of(t, [&](int v) { return position(m, v)[axis] == 10.0; });
    };
  };
  std::erase_if(flat.triangles, is_on(2));
  expect_volume(repair(flat), 1000, "a side is missing");
  for (const Eigen::Index axis : {0, 1, 2}) std::erase_if(m.triangles, is_on(axis));
  const std::string refusal = repair(m).refusal;
  EXPECT_TRUE(refusal.starts_with("filling the hole of 6 edges at ")) << refusal;
  EXPECT_NE(refusal.find("at most 25 % are filled"), std::string::npos) << refusal;
}

/// Corners scattered by a millionth: the distance that is proposed closes them.
TEST(RepairNearPoints, are_closed_by_the_weld_that_is_proposed) {
  for (const double scatter : {1e-6, 1e-5, 3e-4, 2e-3}) {
    TriangleMesh soup;
    for (const Triangle& t : ten.triangles) {
      const int n = static_cast<int>(soup.positions.size());
      for (const int v : t) {
        const double k = static_cast<double>((soup.positions.size() * 7) % 11) / 5.0 - 1.0;
        soup.positions.push_back(position(ten, v) + scatter * Vec3(k, -k, k));
      }
      soup.triangles.push_back({n, n + 1, n + 2});
    }
    const auto hint = crack_hint({{"part", soup}});
    ASSERT_TRUE(hint) << scatter;
    EXPECT_EQ(hint->after, 0u);
    const Repaired r = repair(soup, {hint->distance});
    EXPECT_EQ(r.refusal, "");
    EXPECT_NEAR(enclosed_volume(r.mesh), 1000, 300 * 2 * scatter) << scatter;
  }
}

/// What CGAL finds wrong is reported by TDBD alone.
TEST(RepairMessages, of_cgal_do_not_reach_the_terminal) {
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  for (int k = 1; k < 12; ++k) {
    TriangleMesh m = battery::sphere(1, 1);
    m.positions[0] *= -0.2 * k;
    m.positions[at(k)] = m.positions[at(k + 1)];
    repair(m);
    m.triangles.resize(m.triangles.size() - static_cast<std::size_t>(k));
    repair(m);
    repair(joined(m, moved(m, Vec3::Constant(0.1 * k))));
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

}  // namespace tdbd::mesh::repair_pieces_test
