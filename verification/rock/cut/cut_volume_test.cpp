#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/random.hpp"
#include "mesh/measures.hpp"
#include "reference/rock/close_surface.hpp"
#include "reference/rock/swept_boolean.hpp"
#include "rock/cut/cut_rock.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock::cut_volume_test {

constexpr double depth = 0.15, advance = 0.317;         // m
const Vec3 heading(std::cos(0.4), std::sin(0.4), 0.0);  // oblique to the rock's rows

/// A disc on edge, as a cutter without back rake: radius 0.4, its axis along the heading, 0.15 deep
/// in the rock. Its widest part is above the surface, so that no rock is left hanging over its
/// groove.
bit::Bit upright_disc() {
  bit::Part p;
  p.name = "disc";
  p.mesh_P = battery::cylinder(0.4, 0.1, 24);
  p.X_BP.R.col(2) = heading;
  p.X_BP.R.col(1) = Vec3::UnitZ();
  p.X_BP.R.col(0) = Vec3::UnitZ().cross(heading);
  bit::Bit b;
  b.parts = {p};
  return b;
}

Pose at(const Vec3& place, double way) {
  return {Mat3::Identity(), place + way * heading + Vec3(0, 0, depth - 0.4)};
}

/// What the program removes from flat rock of n x n cells, with the disc at a place.
double removed(int n, const Vec3& place) {
  const mesh::TriangleMesh flat = battery::flat_rock(0.8, 0.0, n);
  Rock rock = make_rock(mesh::make_surface(flat), 3.2 / n, mesh::bounding_box(flat));
  CutWorkspace work;
  CutReport report;
  cut_rock(rock, prepare_cutting_bit(upright_disc()), at(place, 0.0), at(place, advance), work,
           report);
  return report.removed;
}

/// Exact, by CGAL's booleans.
double twin() {
  const bit::Bit b = upright_disc();
  const auto block = reference::close_surface(battery::flat_rock(0.8, 0.0, 2), 1.0);
  const Pose X_BP = b.parts.front().X_BP;
  return reference::swept_boolean(block, b.parts.front().mesh_P,
                                  {at(Vec3::Zero(), 0.0) * X_BP, at(Vec3::Zero(), advance) * X_BP})
      .removed;
}

/// The rock's mesh resolves a groove's upright walls to an edge length, so the order is 1 or
/// better; the mean over places on the mesh falls faster, because what is missed at one wall is
/// taken at another.
TEST(CutRock, removes_what_the_exact_boolean_does_as_edges_shrink) {
  const double exact = twin();
  constexpr int places = 40;
  double before = 0.0, first = 0.0;
  for (const int n : {16, 32, 64, 128, 256}) {
    Random random{5};
    double square = 0.0;
    for (int k = 0; k < places; ++k) {
      const double cell = 1.6 / n;
      const Vec3 place(random.uniform(-cell, cell), random.uniform(-cell, cell), 0.0);
      const Vec3 middle = place - 0.5 * advance * heading;
      const double error = removed(n, middle) / exact - 1.0;
      square += error * error / places;
    }
    const double error = std::sqrt(square);
    std::printf("  edges %.4f of the disc's diameter: error %.2e of the volume, order %.2f\n",
                1.6 / n / 0.8, error, before > 0.0 ? std::log2(before / error) : 0.0);
    first = first > 0.0 ? first : error;
    before = error;
  }
  const double order = std::log2(first / before) / 4.0;
  std::printf("  observed order over all levels: %.2f\n", order);
  EXPECT_GT(order, 0.9);
  EXPECT_LT(before, 3.9e-4);
}

}  // namespace tdbd::rock::cut_volume_test
