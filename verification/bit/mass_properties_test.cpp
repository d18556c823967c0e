#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/generate.hpp"
#include "core/observed_order.hpp"
#include "mesh/measures.hpp"
#include "reference/bit/monte_carlo_mass.hpp"
#include "reference/mesh/exact_volume.hpp"

namespace tdbd::bit::mass_properties_test {

mesh::TriangleMesh box(const Vec3& lo, const Vec3& size) {
  mesh::TriangleMesh m;
  for (int k = 0; k < 8; ++k)
    m.positions.push_back(lo + size.cwiseProduct(Vec3(k & 1, (k >> 1) & 1, k >> 2)));
  m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return m;
}

mesh::TriangleMesh sphere(int n) {
  std::vector<Ring> rings{{0.0, 1.0, 1}};
  for (int k = 1; k < n; ++k) rings.push_back({std::sin(pi * k / n), std::cos(pi * k / n), 2 * n});
  rings.push_back({0.0, -1.0, 1});
  return surface_of_revolution(rings);
}

mesh::TriangleMesh moved(mesh::TriangleMesh m, const Pose& X) {
  for (Vec3& p : m.positions) p = X * p;
  return m;
}

Pose any_pose() {
  const Eigen::Quaterniond q(number(0.1, 1), number(-1, 1), number(-1, 1), number(-1, 1));
  return {q.normalized().toRotationMatrix(), {number(-3, 3), number(-3, 3), number(-3, 3)}};
}

RC_GTEST_PROP(MassProperties, of_a_box_are_exact, ()) {
  const Vec3 lo(number(-5, 5), number(-5, 5), number(-5, 5));
  const Vec3 size(number(0.1, 2), number(0.1, 2), number(0.1, 2));
  const MassProperties p = mass_properties(box(lo, size), 2.0);
  const double mass = 2.0 * size.prod();
  const Vec3 s2 = size.cwiseProduct(size);
  const Vec3 diagonal = mass / 12.0 * (Vec3::Constant(s2.sum()) - s2);
  RC_ASSERT(std::abs(p.mass - mass) < 1e-13 * mass);
  RC_ASSERT((p.centre - (lo + 0.5 * size)).norm() < 1e-13);
  RC_ASSERT((p.inertia - Mat3(diagonal.asDiagonal())).norm() <
            1e-13 * mass * (lo.squaredNorm() + s2.sum()));
}

/// A tetrahedron at the origin with edges a, b, c along the axes: mass abc/6, centre a quarter of
/// each edge, Ixx = m (b^2 + c^2) 3/80 about the centre, Ixy = m ab / 80.
RC_GTEST_PROP(MassProperties, of_a_tetrahedron_are_exact, ()) {
  const Vec3 e(number(0.1, 2), number(0.1, 2), number(0.1, 2));
  mesh::TriangleMesh m;
  m.positions = {Vec3::Zero(), {e.x(), 0, 0}, {0, e.y(), 0}, {0, 0, e.z()}};
  m.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const MassProperties p = mass_properties(m, 3.0);
  const double mass = 3.0 * e.prod() / 6.0;
  Mat3 inertia = mass / 80.0 * e * e.transpose();
  for (int i = 0; i < 3; ++i) inertia(i, i) = 3.0 * mass / 80.0 * (e.squaredNorm() - e[i] * e[i]);
  RC_ASSERT(std::abs(p.mass - mass) < 1e-13 * mass);
  RC_ASSERT((p.centre - 0.25 * e).norm() < 1e-13 * e.norm());
  RC_ASSERT((p.inertia - inertia).norm() < 1e-13 * inertia.norm());
}

/// The polygon prism of n corners has the axial inertia m r^2 (2 + cos(2 pi/n)) / 6 exactly; the
/// cylinder's, m r^2 / 2, is approached with the square of the edge.
TEST(MassProperties, of_a_cylinder_are_those_of_its_prism_and_converge_with_order_2) {
  const auto of_prism = [](int n) {
    return mass_properties(
        surface_of_revolution({{0, 1, 1}, {0.5, 1, n}, {0.5, -1, n}, {0, -1, 1}}), 1.0);
  };
  for (const int n : {8, 16, 32, 64}) {
    const MassProperties p = of_prism(n);
    const double mass = n * 0.25 * std::sin(2 * pi / n);
    EXPECT_NEAR(p.mass, mass, 1e-13 * mass);
    const double axial = mass * 0.25 * (2 + std::cos(2 * pi / n)) / 6;
    EXPECT_NEAR(p.inertia(0, 0), axial, 1e-13 * axial);
    EXPECT_NEAR(p.inertia(1, 1), 0.5 * axial + mass / 3, 1e-13);
  }
  const auto error = [&](int n) { return std::abs(of_prism(n).inertia(0, 0) - pi / 16); };
  for (const int n : {32, 64, 128}) EXPECT_NEAR(std::log2(error(n) / error(2 * n)), 2.0, 0.018);
}

/// The twin throws points: five standard errors, of which none is the program's.
void expect_monte_carlo(const mesh::TriangleMesh& m, std::uint64_t seed) {
  const reference::EstimatedMass e = reference::monte_carlo_mass(m, 40000, seed);
  const MassProperties p = mass_properties(m, 1.0);
  const Mat3 about_origin = p.inertia + p.mass * (p.centre.squaredNorm() * Mat3::Identity() -
                                                  p.centre * p.centre.transpose());
  EXPECT_LT(std::abs(e.volume - p.mass), 5.0 * e.volume_error);
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(std::abs(e.first[i] - p.mass * p.centre[i]), 5.0 * e.first_error[i]) << i;
    for (int k = 0; k < 3; ++k)
      EXPECT_LT(std::abs(e.inertia(i, k) - about_origin(i, k)), 5.0 * e.inertia_error(i, k));
  }
}

TEST(MassProperties, are_those_that_monte_carlo_finds) {
  expect_monte_carlo(moved(sphere(6), {Mat3::Identity(), {0.1, -0.2, 1}}), 1);
  expect_monte_carlo(example_bit('b').parts.back().mesh_P, 2);
  Cutter worn = table('a').front();
  worn.wear = 4e-3;
  expect_monte_carlo(cutter_parts(worn, {Grading::graded, 16, 2e-3}).back().mesh_P, 3);
}

/// Inscribed polyhedra approach the sphere with the square of the edge: halving it divides by 4.
TEST(MassProperties, of_a_sphere_converge_with_order_2) {
  const auto error = [](int n) {
    const MassProperties p = mass_properties(sphere(n), 1.0);
    EXPECT_LT(p.centre.norm(), 1e-12);
    return std::abs(p.inertia(0, 0) - 8.0 * pi / 15.0);
  };
  for (const int n : {16, 32, 64}) EXPECT_NEAR(std::log2(error(n) / error(2 * n)), 2.0, 0.02);
}

RC_GTEST_PROP(MassProperties, move_with_the_body, ()) {
  const Pose X = any_pose();
  const mesh::TriangleMesh m = box({-1, 0, 2}, {1, 2, 0.5});
  const MassProperties a = transformed(mass_properties(m, 3.0), X);
  const MassProperties b = mass_properties(moved(m, X), 3.0);
  RC_ASSERT(std::abs(a.mass - b.mass) < 1e-13);
  RC_ASSERT((a.centre - b.centre).norm() < 1e-13);
  RC_ASSERT((a.inertia - b.inertia).norm() < 1e-12);
}

RC_GTEST_PROP(MassProperties, of_two_halves_are_those_of_the_whole, ()) {
  const double cut = number(0.1, 0.9);
  const MassProperties whole = mass_properties(box({0, 0, 0}, {1, 2, 3}), 1.0);
  const MassProperties sum = combined(mass_properties(box({0, 0, 0}, {cut, 2, 3}), 1.0),
                                      mass_properties(box({cut, 0, 0}, {1 - cut, 2, 3}), 1.0));
  RC_ASSERT((sum.centre - whole.centre).norm() < 1e-13);
  RC_ASSERT((sum.inertia - whole.inertia).norm() < 1e-12);
}

/// What adds up about one point in one frame: mass, its first moment, and inertia about the origin.
struct Moments {
  double mass = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 inertia = Mat3::Zero();

  void add(const MassProperties& p) {
    mass += p.mass;
    first += p.mass * p.centre;
    inertia += p.inertia + p.mass * (p.centre.squaredNorm() * Mat3::Identity() -
                                     p.centre * p.centre.transpose());
  }
};

/// Parts whose points are first taken to the bit's frame, with volumes in rational numbers.
TEST(MassProperties, of_the_example_bits_are_sums_over_their_parts) {
  for (const char letter : {'a', 'b', 'c'}) {
    const Bit bit = example_bit(letter);
    Moments parts, whole;
    double mass = 0.0;
    for (const Part& part : bit.parts) {
      if (part.density == 0.0) continue;
      const mesh::TriangleMesh part_B = moved(part.mesh_P, part.X_BP);
      parts.add(mass_properties(part_B, part.density));
      mass += part.density * reference::enclosed_volume_exact(part_B);
    }
    whole.add(mass_properties(bit));
    EXPECT_NEAR(whole.mass, mass, 2e-14 * mass);
    EXPECT_LT((whole.first - parts.first).norm(), 6e-17 * mass);        // m; 2e-17 seen
    EXPECT_LT((whole.inertia - parts.inertia).norm(), 1.2e-17 * mass);  // m2; 4e-18 seen
  }
}

}  // namespace tdbd::bit::mass_properties_test

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
