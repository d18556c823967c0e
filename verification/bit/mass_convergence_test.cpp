#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "bit/generate.hpp"
#include "bit/mass_properties.hpp"
#include "bit/surface_of_revolution.hpp"
#include "core/observed_order.hpp"

namespace tdbd::bit::mass_convergence_test {

constexpr double exact = 1e-13;  ///< rounding; scale: the body's mass times powers of its size
constexpr double density = 3.0;

Pose any_pose() {
  const Eigen::Quaterniond q(number(0.1, 1), number(-1, 1), number(-1, 1), number(-1, 1));
  return {q.normalized().toRotationMatrix(), {number(-1, 1), number(-1, 1), number(-1, 1)}};
}

mesh::TriangleMesh moved(mesh::TriangleMesh m, const Pose& X) {
  for (Vec3& p : m.positions) p = X * p;
  return m;
}

/// Frustum about the X axis over regular polygons of n corners, radius a at x = 0 and b at x = h.
mesh::TriangleMesh frustum(double a, double b, double h, int n) {
  return surface_of_revolution({{0, h, 1}, {b, h, n}, {a, 0, n}, {0, 0, 1}});
}

/// The same in closed form: sections are similar, of area k r^2 and polar moment
/// k r^4 (2 + cos(2 pi/n)) / 6 with k = n/2 sin(2 pi/n); powers of r are integrated along the axis.
MassProperties frustum_of_polygons(double a, double b, double h, int n) {
  const double k = n / 2.0 * std::sin(2 * pi / n), polar = (2 + std::cos(2 * pi / n)) / 6;
  const double r2 = h * (a * a + a * b + b * b) / 3;
  const double xr2 = h * h * (a * a + 2 * a * b + 3 * b * b) / 12;
  const double xxr2 = h * h * h * (a * a + 3 * a * b + 6 * b * b) / 30;
  const double r4 =
      h * (a * a * a * a + a * a * a * b + a * a * b * b + a * b * b * b + b * b * b * b) / 5;
  const double mass = density * k * r2, centre = xr2 / r2;
  const double axial = density * k * polar * r4;
  const double across = axial / 2 + density * k * xxr2 - mass * centre * centre;
  return {mass, {centre, 0, 0}, Vec3(axial, across, across).asDiagonal()};
}

void expect_exact(const mesh::TriangleMesh& m, const MassProperties& body, double size) {
  const Pose X = any_pose();
  const MassProperties found = mass_properties(moved(m, X), density);
  const MassProperties expected = transformed(body, X);
  RC_ASSERT(std::abs(found.mass - expected.mass) < exact * expected.mass);
  RC_ASSERT((found.centre - expected.centre).norm() < exact * (size + X.p.norm()));
  const double scale = expected.mass * (size * size + X.p.squaredNorm());
  RC_ASSERT((found.inertia - expected.inertia).norm() < exact * scale);
}

RC_GTEST_PROP(MassProperties, of_a_frustum_of_polygons_are_exact, ()) {
  const double a = number(0.2, 1), b = number(0.2, 1), h = number(0.2, 2);
  const int n = *rc::gen::inRange(3, 40);
  expect_exact(frustum(a, b, h, n), frustum_of_polygons(a, b, h, n), 2.0);
}

RC_GTEST_PROP(MassProperties, of_a_cylinder_polygon_are_exact, ()) {
  const double a = number(0.2, 1), h = number(0.2, 2);
  const int n = *rc::gen::inRange(3, 40);
  expect_exact(frustum(a, a, h, n), frustum_of_polygons(a, a, h, n), 2.0);
}

/// A smooth body, the mesh of its level n, and its mass properties.
struct Smooth {
  std::function<mesh::TriangleMesh(int)> mesh;
  MassProperties body;
};

mesh::TriangleMesh cap(double from, double to, int n) {
  std::vector<Ring> rings{{0.0, std::cos(from), 1}};
  for (int k = from > 0.0 ? 0 : 1; k <= n; ++k) {
    const double a = std::lerp(from, to, double(k) / n);
    if (std::sin(a) > 1e-12) rings.push_back({std::sin(a), std::cos(a), 4 * n});
  }
  rings.push_back({0.0, std::cos(to), 1});
  return surface_of_revolution(rings);
}

mesh::TriangleMesh torus(double major, double minor, int n) {
  mesh::TriangleMesh m;
  const int around = 4 * n, across = 2 * n;
  const auto at = [&](int i, int j) { return i % around * across + j % across; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * pi * i / around, v = 2 * pi * j / across;
      const double r = major + minor * std::cos(v);
      m.positions.emplace_back(minor * std::sin(v), r * std::cos(u), r * std::sin(u));
      m.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      m.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  if (mass_properties(m, 1.0).mass < 0.0)
    for (mesh::Triangle& t : m.triangles) std::swap(t[1], t[2]);
  return m;
}

MassProperties of(double mass, double centre, double axial, double across) {
  return {mass, {centre, 0, 0}, Vec3(axial, across, across).asDiagonal()};
}

Smooth sphere() {
  const double m = density * 4 * pi / 3;
  return {[](int n) { return cap(0.0, pi, n); }, of(m, 0, 0.4 * m, 0.4 * m)};
}

/// Half a ball, whose centre is 3/8 of the radius from its face.
Smooth hemisphere() {
  const double m = density * 2 * pi / 3;
  return {[](int n) { return cap(0.0, pi / 2, n); }, of(m, 0.375, 0.4 * m, 83.0 / 320 * m)};
}

Smooth ring() {
  const double a = 1.0, b = 0.4, m = density * 2 * pi * pi * a * b * b;
  return {[=](int n) { return torus(a, b, n); },
          of(m, 0, m * (a * a + 0.75 * b * b), m * (a * a / 2 + 5 * b * b / 8))};
}

Smooth cylinder() {
  const double r = 0.5, h = 1.5, m = density * pi * r * r * h;
  return {[=](int n) { return frustum(r, r, h, 4 * n); },
          of(m, h / 2, m * r * r / 2, m * (3 * r * r + h * h) / 12)};
}

/// The centre is at a quarter of the height for the pyramids too.
Smooth cone() {
  const double r = 0.8, h = 1.2, m = density * pi * r * r * h / 3;
  return {[=](int n) {
            return surface_of_revolution({{0, h, 1}, {r, 0, 4 * n}, {0, 0, 1}});
          },
          of(m, h / 4, 0.3 * m * r * r, m * (0.15 * r * r + 0.0375 * h * h))};
}

/// Mass, centre and the inertia's six entries about the centre, in the frame of the placement.
std::array<double, 10> entries(const MassProperties& p) {
  const Mat3& i = p.inertia;
  return {p.mass,  p.centre.x(), p.centre.y(), p.centre.z(), i(0, 0),
          i(1, 1), i(2, 2),      i(0, 1),      i(1, 2),      i(2, 0)};
}

void expect_order_2(const char* name, const Smooth& smooth) {
  const Pose X{Eigen::AngleAxisd(0.9, Vec3(0.3, -0.5, 0.7).normalized()).toRotationMatrix(),
               {0.2, -0.1, 0.4}};
  const auto exact_entries = entries(transformed(smooth.body, X));
  std::array<std::vector<double>, 10> errors;
  std::vector<double> steps;
  for (const int n : {8, 16, 32, 64, 128}) {
    steps.push_back(1.0 / n);
    const auto found = entries(mass_properties(moved(smooth.mesh(n), X), density));
    for (std::size_t k = 0; k < found.size(); ++k)
      errors[k].push_back(std::abs(found[k] - exact_entries[k]));
  }
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const ObservedOrder o = observed_order(steps, errors[k], 1.0);
    if (o.verdict == OrderVerdict::exact) continue;
    ASSERT_EQ(o.verdict, OrderVerdict::order) << name << " entry " << k;
    EXPECT_NEAR(o.order, 2.0, 0.05) << name << " entry " << k;
  }
  EXPECT_NE(observed_order(steps, errors[0], 1.0).verdict, OrderVerdict::exact) << name;
}

/// Mass, centre and every entry of the inertia, five levels, in a placement without symmetry: order
/// 2, or exact where the polygons have the body's symmetry.
TEST(MassProperties, of_meshes_converge_to_the_smooth_body_with_order_2) {
  expect_order_2("sphere", sphere());
  expect_order_2("hemisphere", hemisphere());
  expect_order_2("torus", ring());
  expect_order_2("cylinder", cylinder());
  expect_order_2("cone", cone());
}

}  // namespace tdbd::bit::mass_convergence_test
