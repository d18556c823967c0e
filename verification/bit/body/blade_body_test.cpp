#include "bit/body/blade_body.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bit/bit.hpp"
#include "bit/cutter/cutter.hpp"
#include "bit/generate_design.hpp"
#include "core/observed_order.hpp"
#include "mesh/check/check.hpp"
#include "mesh/measures.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "reference/mesh/self_intersections.hpp"

namespace tdbd::bit::blade_body_test {

constexpr double chord = 0.35e-3;  ///< m: what a mesh of 6 mm edges stays inside the smooth body

/// Blades that suit any_design: in its sizes.
BladeOptions any_options(const PdcDesign& d) {
  BladeOptions o;
  const double size = d.diameter.gage;
  o.exposure = number(0.2, 0.45) * size;
  o.slot_depth = number(0.06, 0.12) * d.profile.gage_radius;
  o.wall = number(0.02, 0.05) * d.profile.gage_radius;
  o.edge = 6e-3;
  return o;
}

/// Cutters of a random design and blades for them.
struct Bladed {
  std::vector<Cutter> cutters;
  BladeOptions options;
  double gage_radius = 0.0;
};

Bladed any_bladed() {
  const PdcDesign d = any_design();
  Bladed b{laid_out(d), any_options(d), d.profile.gage_radius};
  RC_PRE(blade_problems(b.cutters, b.options, b.gage_radius).empty());
  return b;
}

Part body_of(const Bladed& b) { return blade_body(b.cutters, b.options, b.gage_radius); }

Bladed plain() { return {make_layout(plain_design()).cutters, {}, 107.95e-3}; }

RC_GTEST_PROP(BladeBody, is_closed_oriented_and_does_not_intersect_itself, ()) {
  const mesh::TriangleMesh m = body_of(any_bladed()).mesh_P;
  const auto defects = mesh::check_closed(m);
  if (!defects.empty()) RC_FAIL(mesh::describe(defects, 3));
  RC_ASSERT(reference::self_intersecting_pairs(m) == 0u);
}

TEST(BladeBody, of_the_example_bits_is_a_solid) {
  for (const char letter : {'a', 'b', 'c'}) {
    BladeOptions o;
    o.slot_depth = 15e-3;
    o.exposure = 4e-3;
    const auto problems = blade_problems(table(letter), o, 107.95e-3);
    ASSERT_TRUE(problems.empty()) << letter << problems[0].key << ": " << problems[0].found;
    const Part body = blade_body(table(letter), o, 107.95e-3);
    EXPECT_TRUE(mesh::check_closed(body.mesh_P).empty());
    EXPECT_EQ(reference::self_intersecting_pairs(body.mesh_P), 0u) << letter;
    EXPECT_EQ(body.cutting, Cutting::rubs);
  }
}

/// The first is the axis, with one vertex; on a blade's top the others have some.
TEST(BladeBody, has_vertices_at_every_node_of_the_meridian) {
  const Bladed b = plain();
  const mesh::TriangleMesh m = body_of(b).mesh_P;
  for (const MeridianNode& node : blade_shape(b.cutters, b.options).meridian) {
    double nearest = 1.0;
    for (const Vec3& x : m.positions)
      nearest =
          std::min(nearest, std::hypot(std::hypot(x.x(), x.y()) - node.top.r, x.z() - node.top.z));
    EXPECT_LT(nearest, 1e-12) << node.s;
  }
}

/// A tip stands outside its blade by the exposure less its under-exposure; a point of the cutter's
/// body behind it and under the blade's top is inside.
RC_GTEST_PROP(BladeBody, carries_every_cutter, ()) {
  const Bladed b = any_bladed();
  const mesh::TriangleTree tree(body_of(b).mesh_P);
  for (const Cutter& c : b.cutters) {
    const double bare = b.options.exposure - c.under_exposure;
    RC_ASSERT(!mesh::inside(tree, tip_B(c)));
    const double gap = mesh::distance(tree, tip_B(c));
    RC_ASSERT(gap > bare - 0.1 * b.options.exposure);
    RC_ASSERT(gap < bare + chord);
    const double depth = std::min(b.options.exposure + 0.3 * c.diameter, 0.8 * c.diameter);
    RC_ASSERT(mesh::inside(tree, c.X_BC * Vec3(-0.7 * c.length, 0.0, depth - 0.5 * c.diameter)));
  }
}

/// Volume between the axis and the upper end of the gage, by midpoints over azimuth and along the
/// meridian: V = integral of r^2/2 dz about every half-plane, and the shank in closed form.
double smooth_volume(const Bladed& b, int azimuths, int places) {
  const BladeShape shape = blade_shape(b.cutters, b.options);
  double sum = 0.0;
  for (int j = 0; j < azimuths; ++j) {
    const double azimuth = 2 * pi * (j + 0.5) / azimuths;
    Vec3 last = surface_point_B(shape, shape.meridian.front(), azimuth);
    for (std::size_t i = 1; i < shape.meridian.size(); ++i) {
      const double from = shape.meridian[i - 1].s, to = shape.meridian[i].s;
      for (int k = 1; k <= places; ++k) {
        const Vec3 x = surface_point_B(
            shape, meridian_at(shape, std::lerp(from, to, double(k) / places)), azimuth);
        const double ra = last.head<2>().norm(), rb = x.head<2>().norm();
        sum += (last.z() - x.z()) * (ra * ra + ra * rb + rb * rb) / 6.0;
        last = x;
      }
    }
    const double end = last.head<2>().norm(), shank = b.options.shank_radius * b.gage_radius;
    sum += b.options.neck * (end * end + end * shank + shank * shank) / 6.0;
    sum += b.options.shank_length * b.gage_radius * shank * shank / 2.0;
  }
  return sum * 2 * pi / azimuths;
}

void expect_order_2(const Bladed& b) {
  const double exact = smooth_volume(b, 7000, 60);
  std::vector<double> edges, errors;
  Bladed level = b;
  for (level.options.edge = 4e-3; edges.size() < 5; level.options.edge /= 2.0) {
    edges.push_back(level.options.edge);
    errors.push_back(std::abs(mesh::enclosed_volume(body_of(level).mesh_P) - exact));
  }
  const double order = least_squares_order(edges, errors);
  for (std::size_t k = 0; k < errors.size(); ++k)
    std::printf("edge %.3f mm: error %.3e of the volume\n", 1e3 * edges[k], errors[k] / exact);
  std::printf("observed order %.3f\n", order);
  EXPECT_NEAR(order, 2.0, 0.1);
}

TEST(BladeBody, has_a_volume_that_converges_with_order_2) {
  expect_order_2(plain());
  Bladed spiral = plain();
  PdcDesign d = plain_design();
  d.spiral = 15 * degree;
  spiral.cutters = make_layout(d).cutters;
  expect_order_2(spiral);
}

/// One cutter repeated on n blades at equal angles: the body is the same after a turn by 2 pi / n.
TEST(BladeBody, of_equal_blades_has_their_symmetry) {
  for (const int n : {3, 5}) {
    std::vector<Cutter> cutters;
    for (int k = 0; k < n; ++k)
      for (Cutter c : table('b')) {
        c.id = static_cast<int>(cutters.size()) + 1;
        c.blade = k + 1;
        c.azimuth = 2 * pi * k / n;
        c.X_BC = cutter_pose(c);
        cutters.push_back(c);
      }
    const BladeShape shape = blade_shape(cutters, {});
    for (double s = 0.0; s < shape.meridian.back().s; s += 5e-3)
      for (int j = 0; j < 50; ++j) {
        const MeridianNode at = meridian_at(shape, s);
        EXPECT_NEAR(sunk_share(shape, at, 0.1 * j), sunk_share(shape, at, 0.1 * j + 2 * pi / n),
                    1e-12);
      }
    const MassProperties m = mass_properties(blade_body(cutters, {}, 107.95e-3).mesh_P, 1.0);
    EXPECT_LT(m.centre.head<2>().norm(), 1e-12);
    EXPECT_NEAR(m.inertia(0, 0), m.inertia(1, 1), 1e-12 * m.inertia(0, 0));
  }
}

/// Between the blades' tops at radius a and the slots' floor at b a slot is a sector, but for its
/// walls; the free ring outside the tops is all round.
TEST(BladeBody, has_the_junk_slot_area_of_its_sectors) {
  Bladed b = plain();
  b.options.wall = 1e-7;
  b.options.edge = 0.25e-3;
  const BladeShape shape = blade_shape(b.cutters, b.options);
  const double top = b.gage_radius - b.options.exposure, floor = top - b.options.slot_depth;
  double slots = 2 * pi;
  for (const BladeStrip& blade : shape.blades) slots -= std::asin(blade.width / top);
  const double area =
      pi * (b.gage_radius * b.gage_radius - top * top) + slots / 2 * (top * top - floor * floor);
  EXPECT_NEAR(junk_slot_area(shape, b.options, b.gage_radius) / area, 1.0, 3.3e-6);
}

std::string problem_of(const Bladed& b) {
  const auto problems = blade_problems(b.cutters, b.options, b.gage_radius);
  return problems.empty() ? "" : problems[0].key + ": " + problems[0].found;
}

TEST(BladeBody, reports_what_is_impossible_and_where) {
  Bladed b = plain();
  EXPECT_EQ(problem_of(b), "");
  b.options.slot_depth = 80e-3;
  EXPECT_NE(problem_of(b).find("slot_depth: 80 mm, a floor that folds at radius"),
            std::string::npos)
      << problem_of(b);
  b = plain();
  b.options.exposure = 14e-3;
  EXPECT_NE(problem_of(b).find("exposure: 14 mm, which lifts cutter 1 (blade"), std::string::npos)
      << problem_of(b);
  b = plain();
  b.options.width = 110e-3;
  EXPECT_NE(problem_of(b).find("close the slot between them at radius"), std::string::npos)
      << problem_of(b);
  b = plain();
  b.options.width = 1e-3;
  EXPECT_NE(problem_of(b).find("width: 1 mm, a blade that ends before cutter"), std::string::npos)
      << problem_of(b);
}

/// The deepest slot that a message allows is allowed, and a little more is not.
TEST(BladeBody, reports_the_deepest_slot) {
  Bladed b = plain();
  b.options.slot_depth = 80e-3;
  const std::string most = blade_problems(b.cutters, b.options, b.gage_radius)[0].expected;
  const double depth = std::stod(most.substr(std::string("at most ").size())) * 1e-3;
  b.options.slot_depth = depth;
  EXPECT_EQ(problem_of(b), "");
  b.options.slot_depth = depth + 2e-5;
  EXPECT_NE(problem_of(b), "");
}

}  // namespace tdbd::bit::blade_body_test

namespace tdbd::bit::blade_problems_test {

constexpr double gage_radius = 107.95e-3;  ///< m

std::vector<Cutter> plain() { return make_layout(plain_design()).cutters; }

/// All problems, "key: found, expected" each on a line.
std::string problems_of(const std::vector<Cutter>& cutters, const BladeOptions& options,
                        double gage = gage_radius) {
  std::string all;
  for (const BladeProblem& p : blade_problems(cutters, options, gage))
    all += (all.empty() ? "" : "\n") + p.key + ": " + p.found + ", " + p.expected;
  return all;
}

/// With a back rake of 60 degrees half the diameter of 16 mm stands on the blade: 8 mm, and its under-exposure.
TEST(BladeProblems, keep_every_cutter_on_its_blade) {
  std::vector<Cutter> cutters = plain();
  Cutter& c = cutters[3];
  c.diameter = 16e-3;
  c.back_rake = 60 * degree;
  c.under_exposure = 0.5e-3;
  EXPECT_EQ(problems_of(cutters, {.exposure = 8.499e-3}).find("exposure"), std::string::npos);
  EXPECT_EQ(
      problems_of(cutters, {.exposure = 8.501e-3}),
      fmt::format("exposure: 8.501 mm, which lifts cutter {} (blade {}, radius {:.6g} mm) off "
                  "its blade, less than 8.5 mm",
                  c.id, c.blade, 1e3 * c.tip_radius));
}

/// What wear and under-exposure take from a tip is not outside the blade.
TEST(BladeProblems, leave_something_of_every_cutter_outside) {
  std::vector<Cutter> cutters = plain();
  Cutter& c = cutters[3];
  c.wear = 1.5e-3;
  c.under_exposure = 1e-3;
  EXPECT_EQ(problems_of(cutters, {.exposure = 2.501e-3}).find("exposure"), std::string::npos);
  EXPECT_EQ(problems_of(cutters, {.exposure = 2.499e-3}),
            fmt::format("exposure: 2.499 mm, which leaves nothing of cutter {} (blade {}, radius "
                        "{:.6g} mm) outside the blade: wear 1.5 mm, under-exposure 1 mm, more than "
                        "2.5 mm",
                        c.id, c.blade, 1e3 * c.tip_radius));
  for (Cutter& each : cutters) {
    each.wear = 0.0;
    each.under_exposure = 0.25;  // what is left is 0, exactly
  }
  EXPECT_EQ(problems_of(cutters, {.exposure = 0.25}).find("exposure: 250 mm, which leaves nothing"),
            0U);
}

/// The floor on the gage must leave 0.3 of the gage radius: of a larger gage than the cutters' the slots may be
/// as deep as this leaves.
TEST(BladeProblems, leave_a_core) {
  const BladeOptions shallow{.exposure = 5e-3, .slot_depth = 10e-3};
  const double top = blade_shape(plain(), shallow).meridian.back().top.r;
  const double gage = (top - 12.3456e-3) / 0.3;
  BladeOptions options = shallow;
  options.slot_depth = 12.345e-3;
  EXPECT_EQ(problems_of(plain(), options, gage), "");
  options.slot_depth = 12.346e-3;
  EXPECT_EQ(problems_of(plain(), options, gage),
            fmt::format("slot_depth: 12.346 mm, slots that leave no core: a floor at radius {:.6g} "
                        "mm on the gage, at most 12.34 mm",
                        1e3 * (top - 12.346e-3)));
}

/// A blade may end half a cutter's length before the end of the cutter that trails most.
TEST(BladeProblems, keep_half_of_every_cutter_on_its_blade) {
  const std::vector<Cutter> cutters = plain();
  const BladeShape shape = blade_shape(cutters, {.width = 20e-3});
  double needed = 0.0;
  const Cutter* worst = nullptr;
  for (const Cutter& c : cutters)
    for (const BladeStrip& blade : shape.blades) {
      if (blade.blade != c.blade) continue;
      const Vec3 end_B = c.X_BC * Vec3(-c.length, 0.0, 0.0);
      const double front = front_at(blade, place_of(shape, c));
      const double behind =
          Vec3(std::sin(front), -std::cos(front), 0.0).dot(end_B) - c.length / 2.0;
      if (behind > needed) worst = &c;
      needed = std::max(needed, behind);
    }
  EXPECT_EQ(problems_of(cutters, {.width = needed + 1e-9}), "");
  EXPECT_EQ(problems_of(cutters, {.width = needed - 1e-9}),
            fmt::format("width: {0:.6g} mm, a blade that ends before cutter {1} (blade {2}, radius "
                        "{3:.6g} mm), at least {0:.6g} mm",
                        1e3 * needed, worst->id, worst->blade, 1e3 * worst->tip_radius));
}

/// Six blades every 60 degrees: at the gage there is room for a blade and the walls of the slot behind it.
TEST(BladeProblems, leave_slots_between_blades) {
  const std::vector<Cutter> cutters = plain();
  const BladeShape shape = blade_shape(cutters, {});
  const double s = shape.meridian.back().s, top = shape.meridian.back().top.r;
  double least = 1e9;
  for (std::size_t k = 0; k < shape.blades.size(); ++k) {
    const BladeStrip &a = shape.blades[k], &b = shape.blades[(k + 1) % shape.blades.size()];
    double gap = front_at(b, s) - front_at(a, s);
    if (gap < 0.0) gap += 2.0 * pi;
    least = std::min(least, gap * top);
  }
  const double width = least - 2.0 * 4e-3;
  EXPECT_EQ(problems_of(cutters, {.width = width - 1e-9, .wall = 4e-3}), "");
  const std::string why = problems_of(cutters, {.width = width + 1e-9, .wall = 4e-3});
  EXPECT_NE(why.find(fmt::format("that close the slot between them at radius {:.6g} mm: {:.6g} mm "
                                 "from front to front, more than the width {:.6g} mm and two walls "
                                 "of 4 mm",
                                 1e3 * top, 1e3 * least, 1e3 * width)),
            std::string::npos)
      << why;
  EXPECT_EQ(why.find("width: blades "), 0U) << why;
}

/// Two blades of which one overtakes the other on its way out.
TEST(BladeProblems, keep_blades_one_behind_the_other) {
  std::vector<Cutter> cutters;
  for (const auto& [blade, radius, azimuth] :
       {std::tuple(1, 0.03, 0.0), {1, 0.09, 0.0}, {2, 0.031, 0.6}, {2, 0.091, -0.6}}) {
    Cutter c;
    c.id = static_cast<int>(cutters.size()) + 1;
    c.blade = blade;
    c.diameter = 16e-3;
    c.length = 13e-3;
    c.tip_radius = radius;
    c.tip_height = radius * radius * 2.0;
    c.profile_angle = std::atan(radius * 4.0);
    c.azimuth = azimuth;
    c.X_BC = cutter_pose(c);
    cutters.push_back(c);
  }
  const std::string why = problems_of(cutters, {.exposure = 3e-3, .slot_depth = 5e-3});
  EXPECT_NE(why.find("width: blades 2 and 1 that cross at radius "), std::string::npos) << why;
  EXPECT_NE(why.find(" from front to front, blades one behind the other"), std::string::npos)
      << why;
  for (Cutter& c : cutters)
    if (c.blade == 2) c.azimuth = 0.6;
  EXPECT_EQ(problems_of(cutters, {.exposure = 3e-3, .slot_depth = 5e-3}).find("cross"),
            std::string::npos);
}

}  // namespace tdbd::bit::blade_problems_test
