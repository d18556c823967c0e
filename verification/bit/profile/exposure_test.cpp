#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bit/cutter/cutter.hpp"
#include "bit/generate.hpp"
#include "bit/profile/bit_analysis.hpp"
#include "bit/profile/exposure_profile.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::bit::exposure_test {

constexpr double radius = 0.01;     ///< m
constexpr double of_chords = 3e-8;  ///< m: sagitta of the rim's chords, radius (pi/1440)^2 / 2

/// A flat, sharp cutter of 20 mm without rakes on a profile that falls outwards by `angle`.
Cutter flat_cutter(double tip_radius, double height, double angle = 0.0) {
  Cutter c;
  c.diameter = 2.0 * radius;
  c.length = 0.01;
  c.tip_radius = tip_radius;
  c.tip_height = height;
  c.profile_angle = angle;
  c.azimuth = 0.7 * tip_radius / radius;
  c.X_BC = cutter_pose(c);
  return c;
}

RC_GTEST_PROP(Exposure, of_two_equal_cutters_side_by_side_is_the_height_between_circles, ()) {
  const double apart = number(0.01, 0.95) * radius, angle = number(-0.5, 1.2);
  const double r = 0.05 + apart * std::cos(angle), h = apart * std::sin(angle);
  const auto found = exposures({flat_cutter(0.05, 0.0, angle), flat_cutter(r, h, angle)});
  const double expected = radius - std::sqrt(radius * radius - apart * apart);
  const double steepness = apart / std::sqrt(radius * radius - apart * apart);
  for (const double e : found)
    RC_ASSERT(std::abs(e - expected) < of_chords * (1.0 + steepness * steepness));
}

TEST(Exposure, of_a_backup_behind_its_cutter_is_its_under_exposure) {
  const auto found = exposures({flat_cutter(0.05, 0.0), flat_cutter(0.05, 1e-3)});
  EXPECT_NEAR(found[0], 1e-3, 1e-15);
  EXPECT_NEAR(found[1], -1e-3, 1e-15);
}

TEST(Exposure, is_undefined_where_no_other_rim_is_near) {
  EXPECT_TRUE(std::isnan(exposures({flat_cutter(0.05, 0.0)})[0]));
  const auto far = exposures({flat_cutter(0.05, 0.0), flat_cutter(0.05 + 2.01 * radius, 0.0)});
  EXPECT_TRUE(std::isnan(far[0]) && std::isnan(far[1]));
  EXPECT_TRUE(exposures({}).empty());
}

}  // namespace tdbd::bit::exposure_test

namespace tdbd::bit::exposure_profile_test {

double distance_to_segment(const ProfilePoint& p, const ProfilePoint& a, const ProfilePoint& b) {
  const double dr = b.r - a.r, dz = b.z - a.z, length2 = dr * dr + dz * dz;
  const double along = length2 > 0.0 ? ((p.r - a.r) * dr + (p.z - a.z) * dz) / length2 : 0.0;
  const double w = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.r - a.r - w * dr, p.z - a.z - w * dz);
}

double distance_to_line(const ProfilePoint& p, const std::vector<ProfilePoint>& line) {
  double nearest = 1e300;
  for (std::size_t k = 1; k < line.size(); ++k)
    nearest = std::min(nearest, distance_to_segment(p, line[k - 1], line[k]));
  return nearest;
}

TEST(ExposureProfile, of_bit_b_passes_through_every_tip) {
  const Bit bit = example_bit('b');
  const auto profile = exposure_profile(bit.parts, 2e-4);
  for (const Cutter& c : bit.cutters)
    EXPECT_LT(distance_to_line({c.tip_radius, -c.tip_height}, profile), 1.4e-5) << c.id;
}

TEST(ExposureProfile, runs_from_the_axis_to_the_gage_and_never_back) {
  for (const char letter : {'a', 'b', 'c'}) {
    const Bit bit = example_bit(letter);
    const auto profile = exposure_profile(bit.parts, 5e-4);
    EXPECT_EQ(profile.front().r, 0.0);
    EXPECT_NEAR(profile.back().r, bit.gage_radius, 1e-15);
    EXPECT_TRUE(std::ranges::is_sorted(profile, {}, &ProfilePoint::r));
  }
}

/// Each edge counts, whichever of its ends has the smaller number.
TEST(ExposureProfile, does_not_depend_on_the_numbers_of_the_vertices) {
  Bit bit = example_bit('b');
  const auto before = exposure_profile(bit.parts, 5e-4);
  for (Part& part : bit.parts) {
    const int n = static_cast<int>(part.mesh_P.positions.size());
    std::ranges::reverse(part.mesh_P.positions);
    for (mesh::Triangle& t : part.mesh_P.triangles)
      for (int& v : t) v = n - 1 - v;
  }
  const auto after = exposure_profile(bit.parts, 5e-4);
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t k = 0; k < before.size(); ++k) {
    EXPECT_NEAR(after[k].r, before[k].r, 1e-12) << k;
    EXPECT_NEAR(after[k].z, before[k].z, 1e-12) << k;
  }
}

TEST(ExposureProfile, has_points_about_the_spacing_apart) {
  const auto profile = exposure_profile(example_bit('b').parts, 1e-3);
  for (std::size_t k = 1; k < profile.size(); ++k) {
    const ProfilePoint &a = profile[k - 1], &b = profile[k];
    EXPECT_LT(std::hypot(b.r - a.r, b.z - a.z), 1.01e-3);
  }
}

/// A box off the axis, with its middle at z.
Part box_at(double z, Cutting cutting) {
  Part part;
  part.cutting = cutting;
  part.mesh_P = battery::box({30e-3, -5e-3, z - 5.5e-3}, {40e-3, 5e-3, z + 5.5e-3});
  return part;
}

/// The last ray is horizontal, through the middle of the topmost part: between two points of the box's edge.
TEST(ExposureProfile, ends_where_the_last_ray_leaves_the_part) {
  const ProfilePoint end = exposure_profile({box_at(-0.02, Cutting::cuts)}, 1e-3).back();
  EXPECT_NEAR(end.r, std::hypot(40e-3, 5e-3), 1e-12);
  EXPECT_NEAR(end.z, -0.02,
              6.8e-7);  // the edge's points are 0.19 mm apart; rays are not quite even along them
}

/// Points of a cube for which r is about as large as their height above its middle lie on no ray. Their
/// index is beyond any int.
TEST(ExposureProfile, of_a_cube_with_points_just_above_the_last_ray_ends_at_its_corner) {
  for (const double excess : {0.0, 1e-17, 1e-12, 1e-9, 1e-6}) {
    Part cube;
    cube.cutting = Cutting::cuts;
    const double half = 0.02 * (1.0 + excess);
    cube.mesh_P = battery::box({-half, -half, -0.02}, {half, half, 0.02});
    const ProfilePoint end = exposure_profile({cube}, 1e-3).back();
    EXPECT_NEAR(end.r, std::hypot(half, half), 1e-12) << excess;
  }
}

TEST(ExposureProfile, passes_over_parts_that_do_not_cut) {
  const Part idle = box_at(-0.05, Cutting::never), low = box_at(0.0, Cutting::cuts),
             high = box_at(-0.02, Cutting::cuts);
  const auto alone = exposure_profile({low, high}, 1e-3),
             among = exposure_profile({low, idle, high}, 1e-3);
  ASSERT_EQ(among.size(), alone.size());
  EXPECT_EQ(among.back().r, alone.back().r);
  EXPECT_EQ(among.back().z, alone.back().z);
}

/// Is p below the profile, by more than its resolution?
bool is_outside(const ProfilePoint& p, const std::vector<ProfilePoint>& profile) {
  if (p.z < profile.back().z) return p.r > profile.back().r + 5e-5;
  const auto next = std::ranges::upper_bound(profile, p.r, {}, &ProfilePoint::r);
  if (next != profile.end() && p.z <= std::max(next->z, (next - 1)->z)) return false;
  return distance_to_line(p, profile) > 5e-5;
}

/// No point of a cutting part, on its vertices or inside its triangles, lies outside the profile.
TEST(ExposureProfile, encloses_every_cutting_part) {
  for (const char letter : {'a', 'b'}) {
    const Bit bit = example_bit(letter);
    const auto profile = exposure_profile(bit.parts, 2e-4);
    for (const Part& part : bit.parts) {
      if (part.cutting == Cutting::never) continue;
      for (const mesh::Triangle& t : part.mesh_P.triangles)
        for (const Vec3& w : {Vec3(1, 0, 0), Vec3(0.5, 0.5, 0), Vec3(0.2, 0.3, 0.5)}) {
          const auto& x_P = part.mesh_P.positions;
          const Vec3 x = part.X_BP * (w.x() * x_P[t[0]] + w.y() * x_P[t[1]] + w.z() * x_P[t[2]]);
          const ProfilePoint p{std::hypot(x.x(), x.y()), x.z()};
          ASSERT_FALSE(is_outside(p, profile)) << part.name << ' ' << p.r << ' ' << p.z;
        }
    }
  }
}

/// The first cutter of bit B reaches over the axis; its rim crosses it where the circle does, to
/// within what rake and chamfer change.
TEST(ExposureProfile, has_no_slit_at_the_axis) {
  const Bit bit = example_bit('b');
  const Cutter& c = bit.cutters.front();
  const double radius = 0.5 * c.diameter;
  const double circle =
      -c.tip_height - radius + std::sqrt(radius * radius - c.tip_radius * c.tip_radius);
  EXPECT_NEAR(exposure_profile(bit.parts, 1e-3).front().z, circle, 2.5e-3);
}

/// A tetrahedron about the axis, in millimetres, symmetric about the plane y = 0, in which two corners lie. Its lowest
/// face rises towards one side: at each radius it is lowest in that plane, where no edge of it is.
Part tilted_tetrahedron(std::array<int, 4> numbers, int first) {
  const std::array<Vec3, 4> corners{Vec3(20, 0, 20), Vec3(-10, -15, 12.5), Vec3(-10, 15, 12.5),
                                    Vec3(40, 0, -10)};
  Part part;
  part.cutting = Cutting::cuts;
  part.mesh_P.positions.resize(4);
  for (std::size_t i = 0; i < 4; ++i)
    part.mesh_P.positions[static_cast<std::size_t>(numbers[i])] = 1e-3 * corners[i];
  for (mesh::Triangle t : {mesh::Triangle{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    std::ranges::rotate(t, t.begin() + first);
    for (int& v : t) v = numbers[static_cast<std::size_t>(v)];
    part.mesh_P.triangles.push_back(t);
  }
  return part;
}

/// From the axis down to the corner in the plane, and from there along the edge in it to the middle of its height,
/// whatever the order of corners and of their numbers.
TEST(ExposureProfile, of_a_tetrahedron_about_the_axis_is_its_outline) {
  const std::vector<ProfilePoint> outline{{0.0, 15e-3}, {20e-3, 20e-3}, {30e-3, 5e-3}};
  std::array<int, 4> numbers{0, 1, 2, 3};
  do {
    for (int first = 0; first < 3; ++first) {
      const auto profile = exposure_profile({tilted_tetrahedron(numbers, first)}, 1e-3);
      for (const ProfilePoint& p : profile) EXPECT_LT(distance_to_line(p, outline), 1e-12);
      EXPECT_NEAR(profile.back().r, 30e-3, 1e-7);  // a point on the ray beside
    }
  } while (std::ranges::next_permutation(numbers).found);
}

/// The lowest point on the axis of a convex part around it.
double lowest_on_axis(const mesh::TriangleMesh& part) {
  double lowest = -1e300;
  for (const auto& [a, b, c] : part.triangles) {
    Mat3 corners;  // weights of the corners at the point on the axis
    corners << part.positions[a], part.positions[b], part.positions[c];
    corners.row(2).setOnes();
    if (std::abs(corners.determinant()) < 1e-12) continue;
    const Vec3 w = corners.inverse() * Vec3::UnitZ();
    if (w.minCoeff() < -1e-12) continue;
    lowest = std::max(lowest, w.x() * part.positions[a].z() + w.y() * part.positions[b].z() +
                                  w.z() * part.positions[c].z());
  }
  return lowest;
}

/// At the axis the profile is where the axis leaves the part, wherever that is in a triangle, on an edge or at a
/// corner, and although a second part, above the first, is met by rays beside the axis.
RC_GTEST_PROP(ExposureProfile, begins_where_the_axis_leaves_the_part, ()) {
  Part low, high;
  low.cutting = high.cutting = Cutting::cuts;
  low.mesh_P = *battery::convex_polyhedron();
  low.X_BP.p = Vec3(*battery::number(-0.1, 0.1), *battery::number(-0.1, 0.1), 0.0);
  for (Vec3& x_P : low.mesh_P.positions) x_P = 0.02 * (low.X_BP * x_P);
  low.X_BP = {};
  high.mesh_P = battery::box({-1e-3, -1e-3, -0.05}, {1e-3, 2e-3, -0.03});
  const double lowest = lowest_on_axis(low.mesh_P);
  const auto profile = exposure_profile({low, high}, 1e-3);
  RC_ASSERT(std::abs(profile.front().z - lowest) < 1e-12);
}

/// A level face whose triangle around the axis has no edge near it, above a ring that rays beside the axis would meet.
TEST(ExposureProfile, is_level_where_a_level_triangle_contains_the_axis) {
  Part low, high;
  low.cutting = high.cutting = Cutting::cuts;
  const Vec3 a(20e-3, 0, 10e-3), b(-10e-3, 15e-3, 10e-3), c(-10e-3, -15e-3, 10e-3),
      top(1e-3, 2e-3, -5e-3);
  low.mesh_P = {{a, b, c, top}, {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}}};
  high.mesh_P = battery::box({-1e-3, -1e-3, -20e-3}, {1e-3, 2e-3, -1e-3});
  const auto profile = exposure_profile({low, high}, 1e-3);
  for (std::size_t k = 0; k < profile.size() && profile[k].r < 8e-3; ++k)
    EXPECT_NEAR(profile[k].z, 10e-3, 1e-12) << profile[k].r;
}

/// A thin disc in the half-plane: its meridian is its own rim, from where the rays first touch it.
TEST(ExposureProfile, of_a_sharp_cutter_without_rake_is_its_rim) {
  Cutter c = table('b').at(8);
  c.tip_radius = 0.03;
  c.profile_angle = c.back_rake = c.side_rake = c.chamfer = 0.0;
  c.length = c.table_thickness = 1e-6;
  c.X_BC = cutter_pose(c);
  const auto profile = exposure_profile({cutter_parts(c, {Grading::graded, 512, 0}).front()}, 1e-4);
  for (const ProfilePoint& p : profile) {
    if (p.r < c.tip_radius - 0.1 * c.diameter) continue;
    const double to_centre = std::hypot(p.r - c.tip_radius, p.z + c.tip_height + 0.5 * c.diameter);
    EXPECT_NEAR(to_centre, 0.5 * c.diameter, 1.5e-6);
  }
}

}  // namespace tdbd::bit::exposure_profile_test
