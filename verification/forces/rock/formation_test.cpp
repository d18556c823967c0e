#include "forces/rock/formation.hpp"

#include <gtest/gtest.h>

#include "forces/generate.hpp"

namespace tdbd::forces::formation_test {

Strength strong(double confined) { return {.unconfined = 10 * MPa, .confined = confined}; }

/// 10, 20, 30 MPa with planes at 0 and 0.1 m.
Formation beds() {
  Formation f;
  f.tops = {0.0, 0.1};
  f.strengths = {strong(10 * MPa), strong(20 * MPa), strong(30 * MPa)};
  return f;
}

double at(const Formation& f, const Vec3& x_W) { return strength_at(f, x_W).confined / MPa; }

TEST(Formation, of_level_beds_is_told_by_depth) {
  EXPECT_EQ(at(beds(), Vec3(1, 2, -1e-9)), 10);
  EXPECT_EQ(at(beds(), Vec3(1, 2, 0.0)), 20);
  EXPECT_EQ(at(beds(), Vec3(-3, 0, 0.0999)), 20);
  EXPECT_EQ(at(beds(), Vec3(0, 0, 0.1)), 30);
  EXPECT_EQ(at(beds(), Vec3(0, 0, 1e9)), 30);
}

/// Beds that dip by 30 degrees to +x lie tan 30 deeper a metre on; along the strike nothing
/// changes.
TEST(Formation, of_dipping_beds_lies_deeper_to_the_side_of_the_dip) {
  Formation f = beds();
  f.normal_W = bedding_normal(30 * degree, 0.0);
  const double deeper = std::tan(30 * degree);
  for (const double x : {-1.0, 0.0, 0.5, 2.0})
    for (const double y : {-4.0, 0.0, 3.0}) {
      EXPECT_EQ(at(f, Vec3(x, y, deeper * x - 1e-9)), 10) << x << ' ' << y;
      EXPECT_EQ(at(f, Vec3(x, y, deeper * x + 1e-9)), 20) << x << ' ' << y;
      EXPECT_EQ(at(f, Vec3(x, y, deeper * x + 0.1 / std::cos(30 * degree) + 1e-9)), 30);
    }
}

/// The slow twin: count the planes that are passed.
RC_GTEST_PROP(LayerAt, counts_the_planes_above_a_point, ()) {
  Formation f;
  f.normal_W = bedding_normal(number(0.0, 90 * degree), number(0.0, 2 * pi));
  double top = number(-1.0, 0.0);
  const std::size_t layers = 1 + index(20);
  f.tops.reserve(layers);
  for (std::size_t k = 0; k + 1 < layers; ++k) f.tops.push_back(top += number(1e-3, 0.1));
  f.strengths.assign(layers, strong(10 * MPa));
  RC_ASSERT(formation_problem(f).empty());
  const Vec3 x = number(0.0, 2.0) * any_direction();
  std::size_t passed = 0;
  for (const double t : f.tops) passed += f.normal_W.dot(x) >= t ? 1 : 0;
  RC_ASSERT(layer_at(f, x) == passed);
}

TEST(FormationProblem, says_what_is_wrong) {
  EXPECT_EQ(formation_problem(beds()), "");
  Formation f = beds();
  f.tops = {0.1, 0.1};
  EXPECT_EQ(formation_problem(f), "a plane at 0.1 m after one at 0.1 m, expected rising depths");
  f = beds();
  f.strengths.pop_back();
  EXPECT_EQ(formation_problem(f), "2 rocks between 2 planes, expected one rock more than planes");
  f = beds();
  f.normal_W *= 2;
  EXPECT_EQ(formation_problem(f), "a normal of length 2, expected 1");
  f = beds();
  f.strengths[1].confined = 0.0;
  EXPECT_EQ(formation_problem(f), "a strength of 10000000 Pa, confined 0 Pa, expected > 0");
}

}  // namespace tdbd::forces::formation_test
