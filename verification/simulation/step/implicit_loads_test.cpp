#include "simulation/step/implicit_loads.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/random.hpp"
#include "reference/dynamics/pressed_contacts.hpp"

namespace tdbd::simulation::implicit_loads_test {

/// A body of 1 kg on pads at random places, with random compliance, and without cones.
struct PadScene {
  ForcePlan plan;
  bit::Bit bit;
  Pose X_WB;
  std::vector<CutOfPart> cuts;
  dynamics::Response response;
  ImplicitWork work;

  ResistedMotion motion() const { return {plan, bit, X_WB, Vec3::Zero(), 1e-3, cuts, response}; }
};

enum class Law { rigid, ramp, weakening };

PadScene random_scene(Random& random, Law which) {
  const auto number = [&](double lo, double hi) { return random.uniform(lo, hi); };
  const auto vector = [&](double size) {
    return Vec3(number(-size, size), number(-size, size), number(-size, size));
  };
  PadScene scene;
  forces::Friction law;
  law.stress = 1e3;
  law.cap = 1e9;
  law.mu = number(0.0, 0.6);
  law.full_angle = which == Law::ramp ? number(0.01, 0.3) : 0.0;
  if (which == Law::weakening) {
    law.weakening = number(0.2, 0.7);
    law.weakening_speed = std::pow(10.0, number(-3.0, 0.0));
  }
  scene.plan.laws[static_cast<std::size_t>(bit::PartKind::gage_pad)] = law;
  const int pads = 1 + static_cast<int>(number(0.0, 4.999));
  for (int i = 0; i < pads; ++i) {
    CutOfPart cut;
    cut.part = i;
    cut.cut.kind = bit::PartKind::gage_pad;
    cut.cut.contact_area = number(0.1, 2.0);
    cut.cut.point = vector(1.0);
    cut.cut.normal = (Vec3(0, 0, 1) + vector(0.8)).normalized();
    cut.cut.strength.confined = 1.0;
    cut.distance = number(0.0, 1.0) < 0.3 ? number(0.0, 1e-4) : 0.0;
    scene.cuts.push_back(cut);
    scene.bit.parts.emplace_back();
  }
  Eigen::MatrixXd root(6, 6);
  for (int i = 0; i < 36; ++i) root(i / 6, i % 6) = number(-1.0, 1.0);
  scene.response.A = 1e-3 * (Eigen::MatrixXd::Identity(6, 6) + 0.3 * root * root.transpose());
  scene.response.free.resize(6);
  for (int i = 0; i < 6; ++i) scene.response.free[i] = number(-1.0, 1.0);
  scene.response.free[2] += number(0.0, 2.0);
  return scene;
}

/// Of the largest limit and of the fastest contact: how far the forces and velocities of the pads
/// are from forces (4) and simulation (13).
double misfit(const PadScene& scene) {
  double worst = 0.0;
  const ImplicitWork& w = scene.work;
  for (std::size_t i = 0; i < scene.cuts.size(); ++i) {
    const PressedContact& c = *w.pressed[i];
    const Vec3 v = w.jacobians[i] * w.u;
    const double into = v.dot(c.normal_W);
    const Vec3 slip = v - into * c.normal_W;
    const double excess =
        into - c.free_speed - c.law.ramp * slip.norm() * c.p / c.law.limit;  // m/s
    const double mu = forces::friction_at(c.law.sliding, slip.norm());
    const bool lifts = c.p <= 0.0, crushes = c.p >= c.law.limit;
    worst = std::max({worst, -c.p / c.law.limit, c.p / c.law.limit - 1.0,
                      lifts     ? excess
                      : crushes ? -excess
                                : std::abs(excess),
                      c.friction_W.norm() / c.law.limit - mu * c.p / c.law.limit});
    // Friction opposes the slip, and reaches mu p where there is one.
    const Vec3 short_of = mu * c.p * slip - slip.norm() * c.friction_W;
    worst = std::max(worst, short_of.norm() / c.law.limit);
  }
  return worst;
}

/// Between the velocities of the program and of projected Gauss-Seidel, of the free velocity.
double distance_from_reference(const PadScene& scene) {
  std::vector<reference::PressedSurface> surfaces;
  for (std::size_t k = 0; k < scene.cuts.size(); ++k) {
    const PressedContact& c = *scene.work.pressed[k];
    surfaces.push_back({scene.work.jacobians[k], c.normal_W, c.law.limit, c.law.ramp, c.free_speed,
                        c.law.sliding.mu});
  }
  const Eigen::VectorXd u =
      reference::pressed_velocity(scene.response.free, scene.response.A, surfaces);
  return (scene.work.u - u).norm() / scene.response.free.norm();
}

std::string name_of(Law law) {
  constexpr std::array names{"rigid", "ramp", "weakening"};
  return names.at(static_cast<std::size_t>(law));
}

class PressedPads : public testing::TestWithParam<Law> {};

INSTANTIATE_TEST_SUITE_P(Laws, PressedPads, testing::Values(Law::rigid, Law::ramp, Law::weakening),
                         [](const auto& tested) { return name_of(tested.param); });

/// A ramp and friction that weakens may have several solutions: only their laws are checked.
TEST_P(PressedPads, satisfy_their_laws_and_agree_with_projected_gauss_seidel) {
  constexpr int scenes = 300, most_unsettled = 3;
  constexpr double of_laws = 1e-8, of_velocity = 1e-8;
  Random random{37};
  int unsettled = 0;
  double worst_law = 0.0, worst_velocity = 0.0;
  for (int i = 0; i < scenes; ++i) {
    PadScene scene = random_scene(random, GetParam());
    const ResistedMotion m = scene.motion();
    scene.work.u = scene.response.free;
    prepare(m, scene.work);
    if (!find_resisted_velocity(m, scene.work).has_converged) {
      ++unsettled;
      continue;
    }
    worst_law = std::max(worst_law, misfit(scene));
    if (GetParam() != Law::rigid) continue;  // several solutions
    worst_velocity = std::max(worst_velocity, distance_from_reference(scene));
  }
  fmt::print("unsettled {}, laws {:.1e}, velocity {:.1e}\n", unsettled, worst_law, worst_velocity);
  EXPECT_LE(unsettled, most_unsettled);
  EXPECT_LT(worst_law, of_laws);
  EXPECT_LT(worst_velocity, of_velocity);
}

/// Stops the motion along one direction of velocities in a scene, but for a rounding.
void stop_motion(Random& random, double rounding, PadScene& scene) {
  Eigen::VectorXd along(6);
  for (int i = 0; i < 6; ++i) along[i] = random.uniform(-1.0, 1.0);
  along.normalize();
  const Eigen::MatrixXd rest = Eigen::MatrixXd::Identity(6, 6) - along * along.transpose();
  scene.response.A = (rest * scene.response.A * rest).eval();
  scene.response.A += rounding * along * along.transpose();
  scene.response.free = (rest * scene.response.free).eval();
}

/// The largest singular value of S C S, S^2 the symmetric part of A without its negative rounding.
double steepness_by_definition(const PadScene& scene) {
  const Eigen::MatrixXd& A = scene.response.A;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(0.5 * (A + A.transpose()));
  const Eigen::MatrixXd S = eigen.eigenvectors() *
                            eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
                            eigen.eigenvectors().transpose();
  return Eigen::JacobiSVD<Eigen::MatrixXd>(S * scene.work.C * S).singularValues()[0];
}

/// A damper or friction at the wall that stops a motion makes the compliance singular. The rounding
/// on it has either sign, so that Cholesky's factorisation fails or has a pivot of noise.
TEST(PressedPads, settle_where_the_compliance_is_singular) {
  constexpr int scenes = 200;
  constexpr double of_laws = 3e-9, of_velocity = 2e-9, of_rounding = 1e-12;
  for (const double rounding : {-1e-17, 0.0, 1e-19}) {
    Random random{38};
    int unsettled = 0;
    double worst_law = 0.0, worst_velocity = 0.0;
    for (int i = 0; i < scenes; ++i) {
      PadScene scene = random_scene(random, Law::rigid);
      stop_motion(random, rounding, scene);
      const ResistedMotion m = scene.motion();
      scene.work.u = scene.response.free;
      prepare(m, scene.work);
      unsettled += find_resisted_velocity(m, scene.work).has_converged ? 0 : 1;
      worst_law = std::max(worst_law, misfit(scene));
      worst_velocity = std::max(worst_velocity, distance_from_reference(scene));
      const double bound = steepness(m, scene.work.u, scene.work);
      EXPECT_GE(bound * (1.0 + of_rounding), steepness_by_definition(scene)) << rounding << i;
    }
    fmt::print("rounding {}: unsettled {}, laws {:.1e}, velocity {:.1e}\n", rounding, unsettled,
               worst_law, worst_velocity);
    EXPECT_EQ(unsettled, 0) << rounding;
    EXPECT_LT(worst_law, of_laws) << rounding;
    EXPECT_LT(worst_velocity, of_velocity) << rounding;
  }
}

}  // namespace tdbd::simulation::implicit_loads_test
