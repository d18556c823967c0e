#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/observed_order.hpp"
#include "rock/section/section.hpp"
#include "verification/battery/shapes.hpp"

/// What a section says of the rock at the face while the bit goes deeper than the rock ahead of it was
/// cut: a disc that turns about an axis beside it and goes down into flat rock.
namespace tdbd::rock::section_at_face_test {

constexpr double radius = 0.3, deepest = 0.1, rake = 0.3;        // m, m, rad
constexpr double from_axis = 0.8, turning = 1.3, sinking = 0.3;  // m, rad/s, m/s
const rotation::Twist screw{Vec3(0.0, 0.0, turning), Vec3(0.0, 0.0, sinking)};

/// The frame of a disc that looks along x and leans over the rock ahead.
Pose disc_on_bit() {
  Pose X_BF;
  X_BF.R.col(0) = Vec3(std::cos(rake), 0.0, std::sin(rake));
  X_BF.R.col(2) = Vec3(std::sin(rake), 0.0, -std::cos(rake));
  X_BF.R.col(1) = X_BF.R.col(2).cross(X_BF.R.col(0));
  X_BF.p = Vec3(0.0, -from_axis, 0.0);
  return X_BF;
}

SectionFace disc() {
  constexpr int points = 8192;
  FaceOutline face;
  face.X_BF = disc_on_bit();
  for (int k = 0; k < points; ++k) {
    const double a = 2.0 * std::numbers::pi * k / points;
    face.rim_F.emplace_back(radius * std::sin(a), -radius * std::cos(a));
  }
  return section_face(std::move(face));
}

/// A section as numbers, none of which is small.
using Numbers = std::array<double, 8>;
constexpr std::array<const char*, 8> names{"area",        "centroid y", "centroid z",  "edge",
                                           "edge middle", "attack",     "volume rate", "edge x"};

Numbers numbers_of(const Section& s) {
  const Pose X_FB = inverse(disc_on_bit());
  const Vec3 c_F = X_FB * s.centroid_B, e_F = X_FB * s.edge_centroid_B;
  return {s.area,  1.0 + c_F.y(),     c_F.z(),       s.engaged_edge,
          e_F.z(), s.angle_of_attack, s.volume_rate, 1.0 + s.edge_centroid_B.x()};
}

/// The circular segment that is in the rock, by its closed forms; the angle of attack by Simpson's rule.
Numbers at_the_face() {
  const double height = deepest / std::cos(rake), half = std::acos(1.0 - height / radius);
  const double area = radius * radius * (half - std::sin(half) * std::cos(half));
  const double deep = 2.0 / 3.0 * radius * radius * radius * std::pow(std::sin(half), 3) / area;
  const double edge = 2.0 * radius * half, middle = radius * std::sin(half) / half;
  const Pose X_BF = disc_on_bit();
  const auto velocity = [&](double y, double z) {
    const Vec3 x_B = X_BF * Vec3(0.0, y, z);
    return Vec3(screw.linear_B + screw.angular_B.cross(x_B));
  };
  constexpr int pieces = 2000;
  double attack = 0.0;
  for (int i = 0; i <= pieces; ++i) {
    const double a = half * (2.0 * i / pieces - 1.0);
    const Vec3 v = velocity(radius * std::sin(a), -radius * std::cos(a));
    const double weight = i == 0 || i == pieces ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    attack += weight / (3.0 * pieces) * std::asin(X_BF.R.col(0).dot(v) / v.norm());
  }
  const double rate = area * X_BF.R.col(0).dot(velocity(0.0, -deep));
  return {area,    1.0,    -deep, edge,
          -middle, attack, rate,  1.0 + (X_BF * Vec3(0.0, 0.0, -middle)).x()};
}

/// Errors of every number, relative, at falling leads.
std::array<std::vector<double>, 8> errors_at(const std::vector<double>& leads,
                                             SectionAtFace at_face) {
  const mesh::TriangleMesh flat = battery::flat_rock(2.0, 0.0, 20);
  const Rock rock = make_rock(mesh::make_surface(flat), 0.2, mesh::bounding_box(flat));
  const Pose X_WB{Mat3::Identity(), Vec3(-0.07, from_axis, deepest - radius * std::cos(rake))};
  const Numbers exact = at_the_face();
  std::array<std::vector<double>, 8> errors;
  SectionWork work;
  for (const double lead : leads) {
    const Numbers found = numbers_of(section(
        rock, disc(), X_WB, screw, {.lead = lead, .reach = 0.15, .at_face = at_face}, work));
    for (std::size_t i = 0; i < exact.size(); ++i)
      errors[i].push_back(std::abs(found[i] / exact[i] - 1.0));
  }
  return errors;
}

TEST(SectionAtFace, is_of_second_order_in_the_lead_for_every_number) {
  const std::vector<double> leads{0.02, 0.0141, 0.01, 0.00707, 0.005, 0.00354};
  const auto ahead = errors_at(leads, SectionAtFace::as_ahead);
  const auto extrapolated = errors_at(leads, SectionAtFace::extrapolated);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double largest = *std::ranges::max_element(ahead[i]);
    constexpr double polygon = 1e-5;  // of a circle, far below the errors of the rest
    if (largest < polygon) {
      fmt::print("{}: no error\n", names[i]);
      EXPECT_LT(*std::ranges::max_element(extrapolated[i]), polygon) << names[i];
      continue;
    }
    const double first = least_squares_order(leads, ahead[i]),
                 second = least_squares_order(leads, extrapolated[i]);
    fmt::print("{}: order {:.2f}, error {:.1e}; extrapolated: order {:.2f}, error {:.1e}\n",
               names[i], first, ahead[i].back(), second, extrapolated[i].back());
    EXPECT_NEAR(first, 1.0, 0.2) << names[i];
    EXPECT_NEAR(second, 2.0, 0.2) << names[i];
  }
}

/// A step in the rock ahead makes the straight line too steep: never less than nothing.
TEST(SectionAtFace, is_nothing_where_the_line_falls_below_nothing) {
  mesh::TriangleMesh ramp = battery::flat_rock(2.0, 0.0, 40);
  for (Vec3& x : ramp.positions) x.z() = -0.9 * std::max(0.0, x.x());
  const Rock rock = make_rock(mesh::make_surface(ramp), 0.2, mesh::bounding_box(ramp));
  const Pose X_WB{Mat3::Identity(), Vec3(0.05, 0.013, -0.002 - radius * std::cos(rake))};
  FaceOutline face = disc().outline;
  face.X_BF.p.setZero();
  const rotation::Twist along_x{Vec3::Zero(), Vec3(1.0, 0.0, 0.0)};
  SectionWork work;
  const SectionPlace ahead{.lead = 0.1, .reach = 0.15};
  SectionPlace at_face = ahead;
  at_face.at_face = SectionAtFace::extrapolated;
  EXPECT_GT(section(rock, section_face(face), X_WB, along_x, ahead, work).area, 0.0);
  const Section s = section(rock, section_face(face), X_WB, along_x, at_face, work);
  EXPECT_EQ(s.area, 0.0);
  EXPECT_EQ(s.engaged_edge, 0.0);
  EXPECT_EQ(s.sight, Sight::clear);
}

}  // namespace tdbd::rock::section_at_face_test
