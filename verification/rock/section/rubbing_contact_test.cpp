#include "rock/section/rubbing_contact.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "bit/cutter/cutter.hpp"
#include "bit/wear/wear.hpp"
#include "core/types.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "reference/rock/plane_section.hpp"
#include "rock/section/face_columns.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock::rubbing_contact_test {

constexpr double rounding = 6e-14;      // of areas below 10 m2
constexpr double of_a_section = 1e-13;  // m2 and m, of parts of 1 m and sections above 1e-3 m2

bit::Part part_of(mesh::TriangleMesh mesh_P) {
  bit::Part part;
  part.mesh_P = std::move(mesh_P);
  return part;
}

/// Flat rock at z = 0 over |x|, |y| <= half, of edges of 0.1 to 0.15.
Rock flat(double half) {
  const mesh::TriangleMesh m = battery::flat_rock(half, 0.0, static_cast<int>(20.0 * half));
  return make_rock(mesh::make_surface(m), 0.2, mesh::bounding_box(m));
}

ContactPatch contact_of(const Rock& rock, const bit::Part& part, const Pose& X_WP,
                        double edge = 0.15) {
  RubbingWork work;
  RubbingPart prepared = prepare_rubbing_part(part, 0, rock.grid.cell());
  return rubbing_contact(rock, prepared, X_WP, edge, {}, work);
}

/// A block of any sides, whichever way it is turned about the normal, and however its sides cut the
/// triangles.
RC_GTEST_PROP(RubbingContact, of_a_block_is_its_base, ()) {
  const double a = *battery::number(0.02, 0.7), b = *battery::number(0.02, 0.7);
  const double angle = *battery::number(0.0, 6.0), depth = *battery::number(0.001, 0.9);
  const Pose X_WP{Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix(),
                  Vec3(*battery::number(-0.3, 0.3), *battery::number(-0.3, 0.3), depth)};
  const bit::Part block = part_of(battery::box(Vec3(-a, -b, -1.0), Vec3(a, b, 0.0)));
  const ContactPatch c = contact_of(flat(2.0), block, X_WP);
  RC_ASSERT(std::abs(c.area - 4.0 * a * b) < rounding);
  RC_ASSERT((c.area_vector_W + Vec3(0.0, 0.0, 4.0 * a * b)).norm() < rounding);
  RC_ASSERT((c.centroid_W - Vec3(X_WP.p.x(), X_WP.p.y(), 0.0)).norm() < 1e-11);
}

RC_GTEST_PROP(RubbingContact, of_any_convex_part_is_its_section, ()) {
  const mesh::TriangleMesh m = *battery::convex_polyhedron();
  const Pose X_WP = *battery::pose(0.4);
  const ContactPatch c = contact_of(flat(2.5), part_of(m), X_WP);
  const reference::PlaneSection s = reference::plane_section(m, X_WP);
  RC_ASSERT(std::abs(c.area - s.area) < of_a_section);
  RC_ASSERT((c.area_vector_W + c.area * Vec3::UnitZ()).norm() < rounding);
  if (s.area > 1e-3) RC_ASSERT((c.centroid_W - s.centroid).norm() < of_a_section);
}

/// Of a prism that is not convex: between vertices the distance from its sides is exactly linear but
/// at corners.
RC_GTEST_PROP(RubbingContact, of_an_l_is_its_outline_but_for_corners, ()) {
  const mesh::TriangleMesh l = battery::prism(battery::l_outline(1.0, 0.4), -1.0, 0.0);
  const Pose X_WP{Eigen::AngleAxisd(*battery::number(0.0, 6.0), Vec3::UnitZ()).toRotationMatrix(),
                  Vec3(*battery::number(-0.1, 0.1), *battery::number(-0.1, 0.1), 0.5)};
  const ContactPatch c = contact_of(flat(2.5), part_of(l), X_WP);
  double whole = 0.0;
  for (const mesh::Triangle& t : l.triangles) {
    const Vec3 v =
        mesh::area_vector(l.positions[at(t[0])], l.positions[at(t[1])], l.positions[at(t[2])]);
    whole += std::max(0.0, v.z());
  }
  constexpr double of_corners = 6 * 0.15 * 0.15;  // m2: a triangle at each of six corners
  RC_ASSERT(std::abs(c.area - whole) < 0.25 * of_corners);
}

/// Sums over polygons in the frame of the part.
struct PlainSums {
  double area = 0.0;
  Vec3 vector = Vec3::Zero(), moment = Vec3::Zero();

  void add(const PlainSums& s) {
    area += s.area;
    vector += s.vector;
    moment += s.moment;
  }
};

using Polygon = std::vector<Vec3>;

/// What of a polygon lies where these depths, linear along its edges, are not negative.
Polygon clipped(const Polygon& x, const std::vector<double>& depth) {
  Polygon kept;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t j = (i + 1) % x.size();
    if (depth[i] >= 0.0) kept.push_back(x[i]);
    if ((depth[i] >= 0.0) != (depth[j] >= 0.0))
      kept.push_back(x[i] + depth[i] / (depth[i] - depth[j]) * (x[j] - x[i]));
  }
  return kept;
}

void sum_polygon(const Polygon& x, PlainSums& sums) {
  for (std::size_t i = 2; i < x.size(); ++i) {
    const Vec3 vector = mesh::area_vector(x[0], x[i - 1], x[i]);
    const double area = vector.norm();
    sums.add({area, vector, area / 3.0 * (x[0] + x[i - 1] + x[i])});
  }
}

/// Calls visit(corners) for every triangle around its lowest vertex, in the order of these.
template <class Visit>
void visit_triangles(const mesh::Surface& s, const Visit& visit) {
  for (int v = 0; v < s.vertex_slots(); ++v) {
    const mesh::VertexStar& star = s.star(v);
    const int* ring = s.ring(star);
    for (int i = 0; i < star.size - star.open; ++i)
      if (const int a = ring[i], b = ring[(i + 1) % star.size]; a > v && b > v)
        visit(std::array<int, 3>{v, a, b});
  }
}

/// Every triangle of the rock, clipped to the planes of a convex part one after another.
PlainSums plain_contact(const Rock& rock, const mesh::ConvexSolid& solid, const Pose& X_PW) {
  PlainSums sums;
  visit_triangles(rock.surface, [&](const std::array<int, 3>& corners) {
    Polygon x;
    for (const int v : corners) x.push_back(X_PW * rock.surface.position(v));
    for (std::size_t k = 0; k < solid.planes && !x.empty(); ++k) {
      std::vector<double> depth;
      for (const Vec3& p : x) depth.push_back(solid.b[k] - mesh::normal(solid, k).dot(p));
      x = clipped(x, depth);
    }
    sum_polygon(x, sums);
  });
  return sums;
}

/// A convex part that is turned anyhow, with rough rock around and through it.
RC_GTEST_PROP(RubbingContact, of_a_convex_part_is_bitwise_that_of_all_triangles, ()) {
  Rock rock = flat(1.2);
  Random random = battery::any_random();
  for (int v = 0; v < rock.surface.vertex_slots(); ++v)
    if (!rock.surface.is_boundary(v))
      place_vertex(rock, v, rock.surface.position(v) + Vec3(0, 0, random.uniform(-0.05, 0.05)),
                   Notify::journal);
  const mesh::TriangleMesh m = *battery::convex_polyhedron();
  const Pose X_WP = *battery::pose(0.8);
  const ContactPatch c = contact_of(rock, part_of(m), X_WP, 0.2);
  const PlainSums sums = plain_contact(rock, *mesh::convex_solid(m), inverse(X_WP));
  RC_ASSERT(c.area == sums.area);
  RC_ASSERT(c.area_vector_W == Vec3(X_WP.R * sums.vector) || sums.area == 0.0);
  RC_ASSERT(c.centroid_W == X_WP * Vec3(sums.moment / sums.area) || sums.area == 0.0);
}

/// A part that is not convex, from which no search is left out: the vertices inside are found among all.
RC_GTEST_PROP(RubbingContact, of_any_part_finds_every_vertex_inside, ()) {
  const Rock rock = flat(1.2);
  const mesh::TriangleMesh m = *battery::nonconvex_prism();
  const Pose X_WP = *battery::pose(0.5);
  const mesh::TriangleTree tree(m);
  RubbingWork work;
  RubbingPart prepared = prepare_rubbing_part(part_of(m), 0, rock.grid.cell());
  RC_PRE(prepared.tree_P.has_value());
  rubbing_contact(rock, prepared, X_WP, 0.15, {}, work);
  const Pose X_PW = inverse(X_WP);
  for (int v = 0; v < rock.surface.vertex_slots(); ++v)
    if (mesh::inside(tree, X_PW * rock.surface.position(v)))
      RC_ASSERT(std::ranges::binary_search(work.near, v));
}

TEST(RubbingContact, is_none_above_the_rock) {
  const bit::Part block = part_of(battery::box(Vec3(-0.3, -0.3, -1.0), Vec3(0.3, 0.3, 0.0)));
  const ContactPatch c = contact_of(flat(1.0), block, {Mat3::Identity(), Vec3(0, 0, -1e-6)});
  EXPECT_EQ(c.area, 0.0);
  EXPECT_EQ(c.area_vector_W, Vec3::Zero());
}

/// Buffers of one call do not reach into the next.
TEST(RubbingContact, is_the_same_with_used_buffers) {
  const Rock rock = flat(1.0);
  RubbingWork work;
  RubbingPart block = prepare_rubbing_part(
      part_of(battery::box(Vec3(-0.3, -0.3, -1.0), Vec3(0.3, 0.3, 0.0))), 0, 0.2);
  RubbingPart ring = prepare_rubbing_part(part_of(battery::torus(0.4, 0.2, 24, 12)), 1, 0.2);
  const Pose here{Mat3::Identity(), Vec3(0.01, 0.02, 0.1)},
      there{Mat3::Identity(), Vec3(0.5, 0, 0.1)};
  const ContactPatch first = rubbing_contact(rock, block, here, 0.15, {}, work);
  const ContactPatch around = rubbing_contact(rock, ring, there, 0.15, {}, work);
  const ContactPatch again = rubbing_contact(rock, block, here, 0.15, {}, work);
  EXPECT_EQ(first.area, again.area);
  EXPECT_EQ(first.centroid_W, again.centroid_W);
  RubbingWork fresh;
  EXPECT_EQ(rubbing_contact(rock, ring, there, 0.15, {}, fresh).area, around.area);
}

/// A part that was clear of the rock is measured again once a cut moved a vertex into it: of what the
/// step did, it looks at no more than at that.
TEST(RubbingContact, notices_a_vertex_that_the_cut_moved_into_a_part) {
  Rock rock = flat(2.0);
  RubbingPart l = prepare_rubbing_part(
      part_of(battery::prism(battery::l_outline(1.0, 0.4), -1.0, 0.0)), 0, rock.grid.cell());
  const Pose X_WP{Mat3::Identity(), Vec3(0, 0, -0.5)};
  RubbingWork work;
  EXPECT_EQ(rubbing_contact(rock, l, X_WP, 0.15, {}, work).area, 0.0);
  ASSERT_EQ(l.clear.changes, rock.grid.changes());
  CutWorkspace cut;
  cut.changes_before = rock.grid.changes();
  int nearest = 0;
  const Vec3 inside(-0.3, -0.3, -0.6);
  for (int v = 0; v < rock.surface.vertex_slots(); ++v)
    if ((rock.surface.position(v) - inside).norm() <
        (rock.surface.position(nearest) - inside).norm())
      nearest = v;
  place_vertex(rock, nearest, inside, Notify::none);
  RubbingPart not_told = l;
  EXPECT_EQ(rubbing_contact(rock, not_told, X_WP, 0.15, cut, work).area, 0.0);
  cut.groups.emplace_back().moved_in_step = {nearest};
  EXPECT_GT(rubbing_contact(rock, l, X_WP, 0.15, cut, work).area, 0.0);
}

TEST(DepthInRock, is_the_distance_of_rock_from_the_surface_of_the_part) {
  const Rock rock = flat(1.0);
  const bit::Part block = part_of(battery::box(Vec3(-0.5, -0.5, -1.0), Vec3(0.5, 0.5, 0.0)));
  const auto depth = [&](double z) {
    return depth_in_rock(rock.surface, block, {Mat3::Identity(), Vec3(0.0, 0.0, z)});
  };
  EXPECT_NEAR(depth(0.2), 0.2, 1e-15);
  EXPECT_NEAR(depth(0.9), 0.1, 1e-15);  // the top of the block is nearer
  EXPECT_EQ(depth(-0.1), 0.0);
}

}  // namespace tdbd::rock::rubbing_contact_test

namespace tdbd::rock::flat_behind_test {

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

}  // namespace tdbd::rock::flat_behind_test
