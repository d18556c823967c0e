#include <gtest/gtest.h>

#include <cmath>

#include "simulation/step/simulation.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/simulation/mesh_bit.hpp"

/// A block of 1000 kg on four feet on flat rock, against closed forms: it rests, slides, spins, is
/// thrown up and falls. Friction 0.3; together the feet bear 18 kN before they crush the rock.
namespace tdbd::simulation::block_on_plane_test {

constexpr double gravity = 9.81, mu = 0.3;  // m/s2, 1
constexpr double arm = 0.04;                // m, of the feet, along x and y

Case block(double time_step, double duration) {
  const auto folder = test_folder();
  mesh::write_mesh(folder / "foot.off", battery::box({-15, -15, -30}, {15, 15, 0}));
  std::string bit = "name = \"block\"\n";
  int i = 0;
  for (const char* place :
       {"40 mm\", \"40 mm", "-40 mm\", \"40 mm", "-40 mm\", \"-40 mm", "40 mm\", \"-40 mm"})
    bit += std::string("[[parts]]\nname = \"foot-") + std::to_string(i++) +
           "\"\nkind = \"gage-pad\"\nfile = \"foot.off\"\nposition = [\"" + place +
           "\", 0]\nupdate_direction = [0, 0, 1]\n";
  write_file(folder / "bit.toml", bit);
  const std::string file = write_file(
      folder / "case.toml",
      "[bit]\nfile = \"bit.toml\"\n[rock]\nshape = \"flat\"\nradius = \"150 mm\"\n"
      "wall = \"5 mm\"\nedge_length = \"6 mm\"\nmaterial = \"mancos-shale\"\n"
      "[motion]\nkind = \"drilling\"\nrotary_speed = 0\nrate_of_penetration = 0\n"
      "[string]\nmass = 1000\ngravity = 9.81\ntorsional_inertia = 10\nbending_inertia = 10\n"
      "[forces]\nlaw = \"friction\"\nstress = \"5 MPa\"\nmu = 0.3\nfull_angle = 0\n"
      "[time]\nstep = " +
          std::to_string(time_step) + "\nduration = " + std::to_string(duration) + "\n");
  return read_case(file, {});
}

Simulation moving(Case& c, const Vec3& v_W, const Vec3& w_W) {
  dynamics::DrillingVelocity v;
  v.v_W = v_W;
  v.w_W = w_W;
  c.drilling.start = dynamics::make_drilling_state(c.drilling.system, Pose{}, v, {});
  return start(c);
}

void run(const Case& c, Simulation& s) {
  while (s.state.steps_done < c.time.steps) step(c, s);
}

Vec3 centre(const Simulation& s) { return s.state.drive->state.c_W; }

class BlockOnPlane : public testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(TimeSteps, BlockOnPlane, testing::Values(2e-4, 1e-3, 5e-3),
                         [](const auto& tested) {
                           return std::to_string(std::lround(1e6 * tested.param)) + "us";
                         });

TEST_P(BlockOnPlane, rests) {
  constexpr double settled = 5e-9, place = 3e-12;  // of the weight; m
  Case c = block(GetParam(), 0.1);
  Simulation s = moving(c, Vec3::Zero(), Vec3::Zero());
  const Vec3 before = centre(s);
  const double weight = c.drilling.system.mass * gravity;
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    EXPECT_NEAR(-s.work.loads.force_W.z(), weight, settled * weight);
  }
  EXPECT_LT((centre(s) - before).norm(), place);
}

/// v0 t - mu g t^2/2, and at rest after v0^2/(2 mu g).
TEST_P(BlockOnPlane, slides_to_a_stop) {
  const double h = GetParam(), v0 = 0.2;
  Case c = block(h, 0.1);
  Simulation s = moving(c, Vec3(v0, 0.0, 0.0), Vec3::Zero());
  const Vec3 before = centre(s);
  run(c, s);
  const Vec3 way = centre(s) - before;
  EXPECT_NEAR(way.x(), v0 * v0 / (2 * mu * gravity), mu * gravity * h * h);
  EXPECT_LT(std::abs(way.y()) + std::abs(way.z()), 1e-9);
  EXPECT_LT(s.work.velocity.v_W.norm(), 1e-9);
}

/// Feet share the weight so that friction at their base, below the centre of mass, does not tilt it.
TEST_P(BlockOnPlane, that_slides_leans_on_its_front_feet) {
  Case c = block(GetParam(), 0.02);
  const double height = -(Pose{} * c.drilling.system.centre_B).z();  // m, of the centre of mass
  Simulation s = moving(c, Vec3(0.2, 0.0, 0.0), Vec3::Zero());
  run(c, s);
  const double weight = c.drilling.system.mass * gravity;
  double front = 0.0;
  for (const PartLoad& load : s.work.loads.parts)
    if (load.point_W.x() > centre(s).x()) front += load.normal;
  EXPECT_NEAR(front, weight * (0.5 + 0.5 * mu * height / arm), 0.01 * weight);
}

/// w0 t - mu W r t^2/(2 J) until it stops; the feet count as points at r.
TEST_P(BlockOnPlane, spins_to_a_stop) {
  const double h = GetParam(), w0 = 0.5;
  Case c = block(h, 0.2);
  const dynamics::DrillingSystem& system = c.drilling.system;
  Simulation s = moving(c, Vec3::Zero(), Vec3(0.0, 0.0, w0));
  const double J = 1.0 / s.work.drive.at.mobility_W(2, 2);
  run(c, s);
  const double slows = mu * system.mass * gravity * std::sqrt(2.0) * arm / J;
  EXPECT_NEAR(s.state.place.turned, w0 * w0 / (2.0 * slows),
              slows * h * h + 0.01 * w0 * w0 / (2.0 * slows));
  EXPECT_LT(s.work.velocity.w_W.norm(), 1e-8);
}

/// Thrown up, no force acts on it; it lands at v0 and crushes rock over v0^2/(2 (limit/m - g)). The
/// landing is found to the step.
TEST_P(BlockOnPlane, is_thrown_up_and_crushes_the_rock_on_which_it_lands) {
  const double h = GetParam(), v0 = 0.1;
  Case c = block(h, 0.1);
  Simulation s = moving(c, Vec3(0.0, 0.0, -v0), Vec3::Zero());
  const double before = centre(s).z();
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    const bool flies = s.state.drive->state.rotation.time < 2.0 * v0 / gravity - 2.0 * h;
    if (flies) {
      EXPECT_EQ(s.work.loads.force_W.z(), 0.0);
    }
  }
  const double limit = 5e6 * 4.0 * 9e-4;  // N, of four feet of 30 mm
  const double crushed = v0 * v0 / (2.0 * (limit / c.drilling.system.mass - gravity));
  EXPECT_NEAR(centre(s).z() - before, crushed, 2.5 * v0 * h);
  EXPECT_LT(s.work.velocity.v_W.norm(), 1e-9);
}

}  // namespace tdbd::simulation::block_on_plane_test
