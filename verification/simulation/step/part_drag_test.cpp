#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Eigenvalues>

#include "simulation/step/loads.hpp"

namespace tdbd::simulation::part_drag_test {

double some(double lo, double hi) {
  return lo + (hi - lo) * *rc::gen::inRange(0, 1'000'001) / 1'000'000.0;
}

Vec3 some_vector(double size) { return {some(-size, size), some(-size, size), some(-size, size)}; }

/// Any force that does no positive work.
RC_GTEST_PROP(SecantResistance, gives_the_force_and_never_feeds_energy, ()) {
  const Vec3 v = some_vector(0.01);
  RC_PRE(v.norm() > 1e-8);
  const Vec3 any = some_vector(1e4);
  const Vec3 F = any - std::max(0.0, any.dot(v)) / v.squaredNorm() * v;
  const Mat3 C = secant_resistance(v, F);
  const double rounding = 1e-12 * any.norm() / v.norm();  // N s/m
  RC_ASSERT((C * v + F).norm() <= rounding * v.norm());
  const Mat3 even = C + C.transpose();
  RC_ASSERT(Eigen::SelfAdjointEigenSolver<Mat3>(even).eigenvalues()[0] >= -rounding);
}

/// A chamfer that presses and slides, and the whole law of a face.
struct Pressed {
  ForcePlan plan;
  CutOfPart cut;
};

Pressed pressed(bit::PartKind kind) {
  Pressed p;
  p.plan.forces = Forces::on;
  forces::Detournay law;
  law.eps = 45e6;
  law.zeta = 0.8;
  law.sigma = 49e6;
  law.mu = 0.9;
  law.l = 3e-3;
  p.plan.laws.fill(law);
  p.cut.cut.kind = kind;
  p.cut.cut.contact_area = 2e-6;
  p.cut.cut.normal = Vec3(0.2, 0.1, 0.97).normalized();
  if (kind == bit::PartKind::face) {
    p.cut.face_area = 8e-6;
    p.cut.forward_W = Vec3(0.9, 0.1, 0.3).normalized();
    p.cut.cut.engaged_edge = 5e-3;
  }
  return p;
}

class DragOf : public testing::TestWithParam<bit::PartKind> {};

/// Central differences of twice the width.
TEST_P(DragOf, has_the_slope_of_its_law) {
  constexpr double dt = 1e-3, bound = 3.1e-6;  // of the slope; the differences' own
  const Pressed p = pressed(GetParam());
  for (const Vec3& v : {Vec3(2e-4, -1e-4, 3e-4), Vec3(1e-2, 3e-3, 1e-3), Vec3(1e-6, 2e-6, 4e-6)}) {
    const Mat3 D = drag_of(p.plan, p.cut, v, dt, Resistance::tangent).resistance;
    const auto force_at = [&](const Vec3& at) {
      return drag_of(p.plan, p.cut, at, dt, Resistance::secant).force.force;
    };
    const double dv = 2e-5 * v.norm();
    for (int j = 0; j < 3; ++j) {
      const Vec3 slope =
          (force_at(v - dv * Vec3::Unit(j)) - force_at(v + dv * Vec3::Unit(j))) / (2 * dv);
      EXPECT_LT((D.col(j) - slope).norm(), bound * D.norm()) << j;
    }
  }
}

/// Where there is no direction there is still a slope: of a creep into the rock.
TEST_P(DragOf, resists_at_rest) {
  const Pressed p = pressed(GetParam());
  const PartDrag drag = drag_of(p.plan, p.cut, Vec3::Zero(), 1e-3, Resistance::secant);
  EXPECT_TRUE(drag.resistance.allFinite());
  EXPECT_GT(drag.resistance.norm(), 1e4);  // N s/m; F/slip_speed
}

INSTANTIATE_TEST_SUITE_P(Parts, DragOf,
                         testing::Values(bit::PartKind::face, bit::PartKind::chamfer),
                         [](const auto& tested) { return bit::kind_name(tested.param); });

}  // namespace tdbd::simulation::part_drag_test
