#include "dynamics/gyrostat.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/tolerance.hpp"
#include "dynamics/integrator.hpp"
#include "dynamics/momenta.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::dynamics::gyrostat_test {

constexpr double rounding = 1e-14;  // inertias of order one

Mat3 diagonal(double a, double b, double c) { return Vec3(a, b, c).asDiagonal(); }

std::string problem(const Mat3& I, const std::vector<Cone>& cones = {},
                    InertiaCheck check = InertiaCheck::on) {
  return inertia_problem(I, cones, check);
}

TEST(InertiaProblem, accepts_what_a_body_can_have_a_flat_one_included) {
  EXPECT_EQ(problem(diagonal(2, 2.6, 3)), "");
  EXPECT_EQ(problem(diagonal(1, 2, 3)), "");
  EXPECT_EQ(problem(diagonal(2, 2.6, 3), {{Vec3(0.8, 0, 0.6), 0.1}}), "");
}

/// Tolerances are relative: what is sound stays so in any unit.
TEST(InertiaProblem, is_none_for_a_small_body_and_a_large_one) {
  for (const double scale : {1e-12, 1e12}) {
    EXPECT_EQ(problem(scale * diagonal(2, 2.6, 3), {{Vec3(0.8, 0, 0.6), scale * 0.1}}), "");
    EXPECT_NE(problem(scale * diagonal(1, 2, 3.1)), "");
  }
}

/// Of the tolerance half is nothing and twice is too much, in any unit.
TEST(InertiaProblem, is_none_within_the_tolerance_of_the_largest_inertia) {
  for (const double scale : {1e-12, 1.0, 1e12}) {
    const auto unsymmetric = [&](double tolerances) {
      Mat3 I = scale * diagonal(2, 2.6, 3);
      I(0, 1) = tolerances * tolerance::inertia * I.maxCoeff();
      return problem(I, {}, InertiaCheck::off);
    };
    EXPECT_EQ(unsymmetric(0.5), "");
    EXPECT_NE(unsymmetric(2.0).find("not symmetric"), std::string::npos);
    // A disc of 0.9 with a plate of 0.3: together they have nothing to spare about x.
    const auto lacking = [&](double inertia) {
      return problem(scale * (diagonal(0.45, 0.75, 1.2) - diagonal(inertia, 0, 0)),
                     {{Vec3::UnitZ(), scale * 0.9}});
    };
    EXPECT_EQ(lacking(0.1 * tolerance::inertia), "");
    EXPECT_NE(lacking(10.0 * tolerance::inertia), "");
  }
}

/// The rest is bounded by rounding, so that a heavy cone is recognised in any unit.
TEST(InertiaProblem, names_a_heavy_cone_in_any_unit) {
  for (const double scale : {1e-12, 1.0, 1e12})
    EXPECT_NE(problem(scale * diagonal(0.4, 0.9, 1.0), {{Vec3::UnitZ(), scale * 0.9}})
                  .find("more inertia"),
              std::string::npos);
}

/// Of nothing all is symmetric; and where the tolerance is all that is left, the cones took the rest.
TEST(InertiaProblem, of_a_bound_that_is_just_met_has_its_own_name) {
  EXPECT_NE(problem(Mat3::Zero()).find("not positive"), std::string::npos);
  EXPECT_NE(problem(diagonal(tolerance::inertia, 1, 1), {}, InertiaCheck::off).find("more inertia"),
            std::string::npos);
  EXPECT_EQ(problem(diagonal(2.0 * tolerance::inertia, 1, 1), {}, InertiaCheck::off), "");
  const double least = tolerance::inertia;  // the body's share about x is less than nothing by it
  const std::string left =
      problem(diagonal(least, 1.0 - least, 1.0), {{Vec3::UnitZ(), 4.0 * least}});
  EXPECT_NE(left.find("leaves an inertia"), std::string::npos) << left;
}

/// Rounding beside large elements is none beside an element of 0.
TEST(InertiaProblem, is_none_where_rounding_makes_it_unsymmetric) {
  Mat3 rounded = diagonal(2, 2.6, 3);
  rounded(0, 1) = 1e-17;
  EXPECT_EQ(problem(rounded), "");
}

TEST(InertiaProblem, names_a_broken_triangle_inequality_unless_the_check_is_off) {
  EXPECT_NE(problem(diagonal(1, 2, 3.1)).find("triangle inequality"), std::string::npos);
  EXPECT_NE(problem(diagonal(1, 2, 3.1)).find("3.1"), std::string::npos);
  EXPECT_EQ(problem(diagonal(1, 2, 3.1), {}, InertiaCheck::off), "");
}

TEST(InertiaProblem, names_what_the_equations_cannot_use_even_when_the_check_is_off) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Mat3 skewed = diagonal(2, 2, 2);
  skewed(0, 1) = 0.1;
  for (const InertiaCheck check : {InertiaCheck::on, InertiaCheck::off}) {
    EXPECT_NE(problem(diagonal(1, 2, nan), {}, check).find("not finite"), std::string::npos);
    EXPECT_NE(problem(skewed, {}, check).find("not symmetric"), std::string::npos);
    EXPECT_NE(problem(diagonal(-1, 2, 2), {}, check).find("not positive"), std::string::npos);
    EXPECT_NE(problem(diagonal(1, 1, 1), {{Vec3::Zero(), 0.1}}, check).find("axis of length 0"),
              std::string::npos);
    EXPECT_NE(problem(diagonal(1, 1, 1), {{Vec3::UnitX(), -0.1}}, check).find("-0.1"),
              std::string::npos);
    EXPECT_EQ(problem(diagonal(1, 1, 1), {{Vec3::UnitX(), 0.0}}, check),
              "cone 1: an axial inertia of 0 kg m2");
    EXPECT_NE(problem(diagonal(1, 1, 1), {{Vec3::UnitX(), 1.0}}, check).find("more inertia"),
              std::string::npos);
  }
}

TEST(InertiaProblem, counts_the_transverse_inertia_that_every_cone_has) {
  // A disc of axial inertia 0.9 has at least 0.45 about its diameters: nothing is left for the
  // body.
  const std::vector<Cone> disc = {{Vec3::UnitZ(), 0.9}};
  EXPECT_NE(problem(diagonal(0.4, 0.9, 1.0), disc).find("more inertia"), std::string::npos);
  EXPECT_EQ(problem(diagonal(0.4, 0.9, 1.0), disc, InertiaCheck::off), "");
}

TEST(MakeGyrostat, takes_the_cones_out_of_the_locked_inertia_and_finds_its_principal_axes) {
  const Gyrostat g = make_gyrostat(diagonal(2, 2.6, 3), {{Vec3(3, 0, 4), 0.1}});
  EXPECT_NEAR(g.cones[0].axis_B.norm(), 1.0, rounding);
  const Vec3 s(0.6, 0, 0.8);
  EXPECT_LE((g.carrier_B - (diagonal(2, 2.6, 3) - 0.1 * s * s.transpose())).norm(), rounding);
  EXPECT_LE((g.carrier_inverse_B * g.carrier_B - Mat3::Identity()).norm(), rounding);
  const Mat3& Q = g.principal_axes_B;
  EXPECT_LE((Q * g.principal.asDiagonal() * Q.transpose() - g.carrier_B).norm(), rounding);
  EXPECT_NEAR(Q.determinant(), 1.0, rounding);
}

TEST(MakeGyrostat, sees_through_rounding_that_a_body_is_symmetric) {
  std::vector<Cone> cones;
  for (const double angle : {0.0, 2.0943951023931953, 4.1887902047863905})
    cones.push_back({Vec3(std::cos(angle), std::sin(angle), 0.7), 0.1});
  const Gyrostat g = make_gyrostat(diagonal(2, 2, 3), cones);
  EXPECT_EQ(g.principal[0], g.principal[1]);
  EXPECT_NE(g.principal[1], g.principal[2]);
}

TEST(MakeGyrostat, throws_with_the_reason) {
  EXPECT_THROW(make_gyrostat(diagonal(1, 2, 4), {}), InputError);
}

}  // namespace tdbd::dynamics::gyrostat_test

namespace tdbd::dynamics::integrator_test {

constexpr double rounding = 1e-14;

double power_sum(std::span<const double> fractions, int power) {
  double sum = 0.0;
  for (const double f : fractions) sum += std::pow(f, power);
  return sum;
}

TEST(Composition, fractions_are_symmetric_and_sum_to_one) {
  for (const int order : composition_orders) {
    const std::span<const double> f = composition(order);
    EXPECT_NEAR(power_sum(f, 1), 1.0, rounding) << order;
    for (std::size_t i = 0; i < f.size(); ++i) EXPECT_EQ(f[i], f[f.size() - 1 - i]);
  }
}

/// A symmetric step has errors of odd powers: the simplest order conditions require their sums to
/// vanish. The others are seen in the observed orders.
TEST(Composition, odd_power_sums_vanish_up_to_the_order) {
  for (const int order : composition_orders)
    for (int power = 3; power < order; power += 2)
      EXPECT_NEAR(power_sum(composition(order), power), 0.0, rounding) << order << " " << power;
}

TEST(Composition, has_the_published_numbers_of_stages) {
  EXPECT_EQ(composition(2).size(), 1u);
  EXPECT_EQ(composition(4).size(), 5u);
  EXPECT_EQ(composition(6).size(), 9u);
  EXPECT_EQ(composition(8).size(), 17u);
}

TEST(Composition, rejects_other_orders) {
  for (const int order : {0, 1, 3, 5, 10}) EXPECT_THROW(composition(order), RunError) << order;
}

}  // namespace tdbd::dynamics::integrator_test

namespace tdbd::dynamics::momenta_test {

constexpr double rounding = 1e-12;  // momenta and energies here are below 1e3

/// A body with two or three cones that differ, and how all of it moves.
struct Motion {
  Gyrostat g;
  Mat3 R_WB;
  Vec3 w_B;
  std::vector<double> spins, angles;
};

Motion any_motion() {
  Motion m;
  Mat3 I = Vec3(3.0, 4.0, 5.0).asDiagonal();
  std::vector<Cone> cones(static_cast<std::size_t>(*battery::integer(2, 3)));
  for (Cone& c : cones) {
    c = {*battery::direction(), *battery::number(0.01, 0.3)};
    I += c.axial_inertia * Mat3::Identity();
    m.spins.push_back(*battery::number(-20.0, 20.0));
    m.angles.push_back(*battery::number(-6.0, 6.0));
  }
  m.g = make_gyrostat(I, cones);
  m.R_WB = Eigen::AngleAxisd(*battery::number(-3.0, 3.0), *battery::direction()).toRotationMatrix();
  m.w_B = *battery::point(5.0);
  return m;
}

RotationState state_of(const Motion& m) {
  return make_state(m.g, m.R_WB, m.w_B, m.spins, m.angles);
}

/// Everything turns with the bit, and each cone about its axis besides: dynamics (2) without It.
RC_GTEST_PROP(Momenta, are_those_of_locked_cones_and_of_their_spins, ()) {
  const Motion m = any_motion();
  const RotationState s = state_of(m);
  Vec3 momentum_B = m.g.inertia_B * m.w_B;
  for (std::size_t k = 0; k < m.g.cones.size(); ++k) {
    const Cone& c = m.g.cones[k];
    momentum_B += c.axial_inertia * m.spins[k] * c.axis_B;
    const double about_axis = c.axial_inertia * (m.spins[k] + c.axis_B.dot(m.w_B));
    RC_ASSERT(std::abs(s.cone_momenta[k] - about_axis) < rounding);
    RC_ASSERT(s.cone_angles[k] == m.angles[k]);
  }
  RC_ASSERT((s.momentum_W - m.R_WB * momentum_B).norm() < rounding);
  RC_ASSERT((body_momentum(s) - momentum_B).norm() < rounding);
}

RC_GTEST_PROP(Momenta, give_the_velocities_back, ()) {
  const Motion m = any_motion();
  const RotationState s = state_of(m);
  const Vec3 w_B = angular_velocity(m.g, s);
  RC_ASSERT((w_B - m.w_B).norm() < rounding);
  for (std::size_t k = 0; k < m.g.cones.size(); ++k)
    RC_ASSERT(std::abs(cone_rate(m.g.cones[k], s.cone_momenta[k], w_B) - m.spins[k]) < rounding);
}

/// Half of w I w, of Ic spin^2, and what couples them.
RC_GTEST_PROP(Momenta, have_the_energy_of_body_and_spins, ()) {
  const Motion m = any_motion();
  double energy = 0.5 * m.w_B.dot(m.g.inertia_B * m.w_B);
  for (std::size_t k = 0; k < m.g.cones.size(); ++k) {
    const Cone& c = m.g.cones[k];
    energy += c.axial_inertia * m.spins[k] * (0.5 * m.spins[k] + c.axis_B.dot(m.w_B));
  }
  RC_ASSERT(std::abs(kinetic_energy(m.g, state_of(m)) - energy) < rounding);
}

}  // namespace tdbd::dynamics::momenta_test
