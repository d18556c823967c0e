#include "reference/literature/drag/spokes/hanson_hansen_law.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "forces/laws/hanson_hansen.hpp"
#include "forces/part/directions.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::reference::hanson_hansen_law_test {
namespace {

constexpr double rake = 0.3, mm = 1e-3;

SpokeCutter cutter() {
  SpokeCutter c;
  c.back_rake = rake;
  c.chamfer = 0.4 * mm;
  c.chamfer_angle = M_PI / 4.0;
  return c;
}

HansonHansenRock edges() {
  HansonHansenRock rock;
  rock.law = HansonHansenLaw::edges;
  rock.edges.strength = 50e6;
  rock.edges.A1 = 1.1;
  rock.edges.A2 = 0.2;
  rock.edges.A3 = 0.35;
  rock.edges.A4 = 0.5;
  return rock;
}

const Vec3 down = Vec3::UnitZ(), ahead = Vec3::UnitY(),
           face(0.0, std::cos(rake), std::sin(rake));  // looks ahead and down
const CrossingCut cut{8e-6, 0.0, 8e-6, 5 * mm};

/// A chamfer of 45 degrees without rake shows its width; turned until it faces down, all of its slope.
TEST(HansonHansenLaw, sees_a_chamfer_along_the_profiles_normal) {
  SpokeCutter c = cutter();
  c.back_rake = 0.0;
  EXPECT_NEAR(chamfer_shadow(c), 0.4 * mm, 1e-15);
  c.back_rake = M_PI / 4.0;
  EXPECT_NEAR(chamfer_shadow(c), 0.4 * mm * std::sqrt(2.0), 1e-15);
  c.chamfer = 0.0;
  EXPECT_EQ(chamfer_shadow(c), 0.0);
}

TEST(HansonHansenLaw, adds_face_and_chamfer_in_level_motion) {
  const Vec3 F = hanson_hansen_force(edges(), cutter(), cut, down, face, 2.0 * ahead);
  const double faced = 50e6 * (1.1 * (1.0 + 0.2 * std::tan(rake)) * 8e-6 + 0.5 * 1e-4 * 5 * mm);
  const double chamfer = 50e6 * 5 * mm * chamfer_shadow(cutter());
  EXPECT_NEAR(F.y(), -(faced + 0.6 * chamfer), 1e-9 * faced);
  EXPECT_NEAR(F.z(), -(std::tan(rake + 0.35) * faced + chamfer), 1e-9 * faced);
  EXPECT_EQ(F.x(), 0.0);
}

TEST(HansonHansenLaw, rubs_where_the_back_is_ahead) {
  const Vec3 F = hanson_hansen_force(edges(), cutter(), cut, down, face, -2.0 * ahead);
  const double normal = 0.5 * 50e6 * 5 * mm * 1 * mm;
  EXPECT_NEAR(F.z(), -normal, 1e-9 * normal);
  EXPECT_NEAR(F.y(), 0.3 * normal, 1e-9 * normal);
}

/// One law, one effective back rake, forces (2): wherever the face looks. Left out: what only TDBD bounds, near a
/// plunge and beyond 80 degrees, faces that look back, and angles near 0, where a cosine has half the digits.
RC_GTEST_PROP(HansonHansenLaw, of_a_face_is_that_of_tdbd, ()) {
  const Vec3 face_W = *battery::direction(), normal_W = *battery::direction(),
             v_W = 2.0 * *battery::direction();
  const HansonHansenRock rock = edges();
  const double ahead_share = face_W.dot(v_W) / v_W.norm(),
               B = std::acos(std::min(ahead_share, 1.0));
  RC_PRE(ahead_share > 0.0 && B > 1e-3 && B + rock.edges.A3 < forces::steepest_rake);
  RC_PRE(std::abs(normal_W.dot(v_W)) < 0.8 * v_W.norm() && normal_W.dot(v_W) >= 0.0);
  forces::HansonHansen law;
  law.A1 = rock.edges.A1, law.A2 = rock.edges.A2, law.A3 = rock.edges.A3, law.A4 = rock.edges.A4;
  law.te = rock.edges.te;
  law.slip_speed = 0.0;
  forces::PartCut face_cut;
  face_cut.cut_area = cut.area;
  face_cut.engaged_edge = cut.edge;
  face_cut.back_rake = forces::effective_back_rake(face_W, v_W);
  face_cut.velocity = v_W;
  face_cut.normal = normal_W;
  face_cut.strength.confined = face_cut.strength.unconfined = rock.edges.strength;
  SpokeCutter sharp = cutter();
  sharp.chamfer = 0.0;
  const Vec3 F = hanson_hansen_force(rock, sharp, cut, normal_W, face_W, v_W),
             expected = forces::law_force(law, face_cut).force;
  RC_ASSERT((F - expected).norm() <= 1e-12 * expected.norm());
}

TEST(HansonHansenLaw, shares_the_law_of_areas_with_the_other_models) {
  HansonHansenRock rock;
  rock.shared = {100e6, 0.8, 0.0, 0.0};
  const Vec3 F = hanson_hansen_force(rock, cutter(), cut, down, face, {0.0, 2.0, 0.1});
  EXPECT_NEAR((F - Vec3(0.0, -800.0, -640.0)).norm(), 0.0, 1e-9);
  EXPECT_EQ(hanson_hansen_force(edges(), cutter(), {}, down, face, ahead).norm(), 0.0);
}

}  // namespace
}  // namespace tdbd::reference::hanson_hansen_law_test
