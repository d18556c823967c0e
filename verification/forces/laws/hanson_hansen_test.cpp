#include "forces/laws/hanson_hansen.hpp"

#include <gtest/gtest.h>

#include "forces/generate.hpp"

namespace tdbd::forces::hanson_hansen_test {

using bit::PartKind;

HansonHansen example() {
  HansonHansen h;
  h.A1 = 0.9;
  h.A2 = 0.5;
  h.A3 = 20 * degree;
  h.A4 = 0.7;
  h.A5 = 1.3;
  h.A6 = 0.6;
  h.A7 = 0.5;
  h.A8 = 0.3;
  h.slip_speed = 0.0;
  return h;
}

/// By hand, 100 MPa: Ft = 100e6 (0.9 (1 + 0.5 tan 20) 10e-6 + 0.7 1e-4 10e-3) = 1133.7865 N,
/// Fn = tan 40 Ft.
TEST(HansonHansen, of_a_face_is_the_reconstruction_by_hand) {
  const PartForce f = law_force(example(), plain_cut(PartKind::face));
  const double Ft = 100e6 * (0.9 * (1.0 + 0.5 * 0.36397023426620236) * 10e-6 + 0.7 * 1e-4 * 10e-3);
  EXPECT_NEAR(f.tangential, Ft, rounding(Ft));
  EXPECT_NEAR(f.normal, 0.83909963117728 * Ft, 1e-13 * Ft);
  EXPECT_LT((f.force - Vec3(-f.tangential, 0, -f.normal)).norm(), rounding(Ft));
}

/// Rake and A3 together beyond 80 degrees: the ratio stays at tan 80 degrees.
TEST(HansonHansen, of_a_face_has_a_bounded_ratio_of_forces) {
  const double most = std::tan(80 * degree);
  for (const double A3 : {62 * degree, 69 * degree, 85 * degree}) {
    HansonHansen law = example();
    law.A3 = A3;
    const PartForce f = law_force(law, plain_cut(PartKind::face));
    EXPECT_NEAR(f.normal, most * f.tangential, 1e-13 * f.normal);
  }
}

TEST(HansonHansen, of_a_chamfer_presses_with_a_share_of_the_strength) {
  const PartForce f = law_force(example(), plain_cut(PartKind::chamfer));
  EXPECT_DOUBLE_EQ(f.normal, 1.3 * 100e6 * 4e-6);
  EXPECT_DOUBLE_EQ(f.tangential, 0.6 * f.normal);
}

TEST(HansonHansen, of_other_surfaces_has_their_own_coefficients) {
  for (const PartKind kind : {PartKind::cse, PartKind::cutter_body}) {
    const PartForce f = force(Law{example()}, plain_cut(kind));
    EXPECT_DOUBLE_EQ(f.normal, 0.5 * 100e6 * 4e-6);
    EXPECT_DOUBLE_EQ(f.tangential, 0.3 * f.normal);
  }
}

/// te is the length scale of A4 and no coefficient beside it.
RC_GTEST_PROP(HansonHansen, feels_an_edge_by_one_product_alone, ()) {
  Law law = any_law({"hanson-hansen"});
  const PartCut c = any_cut();
  auto twice = std::get<HansonHansen>(law);
  twice.te *= 2.0;
  twice.A4 *= 0.5;
  const PartForce f = force(law, c);
  RC_ASSERT((force(twice, c).force - f.force).norm() <= 1e-13 * size(f));
}

/// 4 mm2 of chamfer at 1.34 times 114 MPa is 610 N.
TEST(HansonHansen, of_an_engaged_chamfer_is_that_of_the_literature) {
  HansonHansen h = example();
  h.A5 = 1.34;
  PartCut c = plain_cut(PartKind::chamfer);
  c.strength.confined = 114 * MPa;
  EXPECT_NEAR(law_force(h, c).normal, 610.0, 2.0);
}

/// A share of 0 leaves the strength without pressure, of 1 the rock's.
TEST(HansonHansen, takes_its_share_of_the_pressure) {
  HansonHansen h = example();
  const PartCut c = plain_cut(PartKind::face);  // 60 MPa, confined 100 MPa
  const double whole = law_force(h, c).tangential;
  h.pressure_share = 0.0;
  EXPECT_NEAR(law_force(h, c).tangential, 0.6 * whole, rounding(whole));
  h.pressure_share = 0.5;
  EXPECT_NEAR(law_force(h, c).tangential, 0.8 * whole, rounding(whole));
}

/// Any coefficients and cut: the sum of the basis is the force.
RC_GTEST_PROP(HansonHansen, is_the_sum_of_coefficients_times_its_basis, ()) {
  Law law = HansonHansen{};
  for (const LawField& f : law_fields(law))
    *f.value = number(std::max(f.range.lo, 0.0), std::min(f.range.hi, 5.0));
  PartCut c = any_cut();
  RC_PRE(HansonHansen::knows(c.kind));
  const auto& h = std::get<HansonHansen>(law);
  const auto factors = linear_coefficients(h);
  const auto basis = force_basis(h, c);
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < hanson_hansen_terms; ++k) sum += factors[k] * basis[k];
  const PartForce f = force(law, c);
  RC_ASSERT((sum - f.force).norm() <= rounding(f.normal + f.tangential));
}

/// Linear least squares on the basis finds the coefficients behind forces again.
TEST(HansonHansen, is_recovered_from_forces_by_linear_least_squares) {
  const HansonHansen h = example();
  Eigen::MatrixXd rows(3 * 60, hanson_hansen_terms);
  Eigen::VectorXd forces(3 * 60);
  for (int k = 0; k < 60; ++k) {
    PartCut c = plain_cut(static_cast<PartKind>(k % 3));
    c.cut_area *= 1.0 + 0.1 * k;
    c.back_rake += 0.01 * (k % 7);
    c.engaged_edge *= 1.0 + 0.3 * (k % 5);
    const auto basis = force_basis(h, c);
    for (int j = 0; j < hanson_hansen_terms; ++j) rows.block<3, 1>(3 * k, j) = basis[j];
    forces.segment<3>(3 * k) = force(Law{h}, c).force;
  }
  const Eigen::VectorXd found = rows.colPivHouseholderQr().solve(forces);
  const auto factors = linear_coefficients(h);
  for (int j = 0; j < hanson_hansen_terms; ++j) EXPECT_NEAR(found[j], factors[j], 1e-12);
}

}  // namespace tdbd::forces::hanson_hansen_test
