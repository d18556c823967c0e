
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "mesh/check/self_intersections.hpp"
#include "mesh/check/weld.hpp"
#include "mesh/measures.hpp"
#include "mesh/repair/repair.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::mesh::unite_test {

/// Every triangle with points of its own, which differ from their mates by up to `crack`.
TriangleMesh cracked(const TriangleMesh& m, double crack) {
  TriangleMesh soup;
  for (const Triangle& t : m.triangles) {
    const int n = static_cast<int>(soup.positions.size());
    for (const int v : t) {
      const double k = static_cast<double>((soup.positions.size() * 7) % 5) / 4.0 - 0.5;
      soup.positions.push_back(position(m, v) + 0.5 * crack * Vec3(k, -k, 0.5 * k));
    }
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  return soup;
}

TEST(WeldHint, finds_the_distance_that_closes_cracks) {
  const TriangleMesh sphere = battery::sphere(0.02, 3), soup = cracked(sphere, 1e-6);
  const auto hint = weld_hint(soup);
  ASSERT_TRUE(hint);
  EXPECT_EQ(hint->before, 3 * sphere.triangles.size());
  EXPECT_EQ(hint->after, 0u);
  EXPECT_EQ(weld_text(*hint), "0.001 mm");
  TriangleMesh welded = soup;
  weld_points(welded, hint->distance);
  EXPECT_TRUE(check_solid(welded).empty());
  EXPECT_EQ(welded.positions.size(), sphere.positions.size());
}

TEST(WeldHint, is_none_for_holes_and_for_closed_meshes) {
  EXPECT_FALSE(weld_hint(battery::sphere(0.02, 2)));
  EXPECT_FALSE(weld_hint(battery::flat_rock(1.0, 0.0, 16)));
  TriangleMesh half = cracked(battery::sphere(0.02, 2), 0.0);  // equal points are no cracks
  EXPECT_FALSE(weld_hint(half));
  half.triangles.resize(100);
  EXPECT_FALSE(weld_hint(half));
}

/// Thousands of pieces make few lines, and the last one is the command that works.
TEST(MeshFaults, of_a_cracked_file_are_few_lines_with_a_weld_distance) {
  std::vector<Solid> pieces;
  const TriangleMesh soup = cracked(battery::sphere(0.02, 3), 1e-6);
  for (TriangleMesh& piece : divide(soup))
    pieces.push_back({"solid-" + std::to_string(pieces.size() + 1), std::move(piece)});
  ASSERT_EQ(pieces.size(), soup.triangles.size());
  const std::vector<std::string> lines = mesh_faults("a.stl", pieces);
  ASSERT_EQ(lines.size(), 15u);
  EXPECT_EQ(lines[12], "a.stl: and 1268 more");
  EXPECT_NE(lines[13].find("with --weld '0.001 mm' 0 edges are open"), std::string::npos);
  EXPECT_EQ(lines[14],
            "a.stl: to repair: tdbd mesh a.stl --repair --weld '0.001 mm' -o a-repaired.stl");
}

bool any(const TriangleMesh&) { return true; }

TEST(Unite, makes_one_sound_solid_of_solids_that_overlap_or_touch) {
  const std::vector<Solid> boxes = {{"a", battery::box({0, 0, 0}, {2, 2, 2})},
                                    {"b", battery::box({1, 1, 1}, {3, 3, 3})},
                                    {"c", battery::box({2, 0, 0}, {4, 2, 1})},      // shares a face
                                    {"d", battery::box({9, 9, 9}, {10, 10, 10})}};  // apart
  const United united = unite(boxes, any);
  EXPECT_EQ(united.refusal, "");
  EXPECT_TRUE(check_solid(united.mesh).empty());
  EXPECT_NEAR(enclosed_volume(united.mesh), 8.0 + 7.0 + 4.0 + 1.0, 1e-13);  // a few roundings
}

/// The union of boxes that touch in an edge is no manifold. Enlarged by a micrometre they overlap.
TEST(Unite, makes_solids_that_touch_in_an_edge_overlap) {
  const Solid a{"a", battery::box({0, 0, 0}, {1, 1, 1})},
      b{"b", battery::box({1, 1, 0}, {2, 2, 1})};
  const United united = unite({a, b}, any);
  EXPECT_EQ(united.refusal, "");
  EXPECT_TRUE(check_solid(united.mesh).empty());
  EXPECT_NEAR(enclosed_volume(united.mesh), 2.0, 1.2e-5);  // 12 faces of 1 m2, each moved by 1 um
}

TEST(Unite, rejects_what_has_no_solid_union) {
  const Solid a{"a", battery::box({0, 0, 0}, {1, 1, 1})};
  TriangleMesh open = a.mesh;
  open.triangles.pop_back();
  EXPECT_EQ(unite({{"open", open}}, any).refusal.find("solid open: hole: 3 times"), 0u);
  EXPECT_NE(unite({a}, [](const TriangleMesh&) { return false; }).refusal.find("rounded"),
            std::string::npos);
  EXPECT_TRUE(unite({}, any).mesh.triangles.empty());
}

}  // namespace tdbd::mesh::unite_test
