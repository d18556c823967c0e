#include "reference/simulation/crushing_feet.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/simulation/coupled/agreement.hpp"
#include "verification/simulation/mesh_bit.hpp"

/// A block on four feet that slides while it spins, and one that rests while its string twists it,
/// against the same block by Runge-Kutta on smooth contacts. Neither has a closed form: friction acts
/// against the slip of each foot.
namespace tdbd::simulation::block_twin_test {

constexpr double stress = 5e6, foot_side = 0.03, arm = 0.04, mu = 0.3;  // Pa, m, m, 1

/// `string`: lines of [string] and [motion] that a situation needs.
Case block(const std::string& motion, const std::string& string, double time_step,
           double duration) {
  const double edge_length = 6.0 * time_step;  // m: both are refined together
  const auto folder = test_folder();
  mesh::write_mesh(folder / "foot.off", battery::box({-15, -15, -30}, {15, 15, 0}));
  std::string bit = "name = \"block\"\n";
  for (const char* place : {"0.04, 0.04", "-0.04, 0.04", "-0.04, -0.04", "0.04, -0.04"})
    bit += fmt::format(
        "[[parts]]\nname = \"foot-{}\"\nkind = \"gage-pad\"\nfile = \"foot.off\"\n"
        "position = [{}, 0]\nupdate_direction = [0, 0, 1]\n",
        bit.size(), place);
  write_file(folder / "bit.toml", bit);
  const std::string file = write_file(
      folder / "case.toml",
      fmt::format("[bit]\nfile = \"bit.toml\"\n[rock]\nshape = \"flat\"\nradius = \"150 mm\"\n"
                  "wall = \"5 mm\"\nedge_length = {}\nmaterial = \"mancos-shale\"\n"
                  "[motion]\nkind = \"drilling\"\nrate_of_penetration = 0\n{}\n"
                  "[string]\nmass = 1000\ntorsional_inertia = 0.5\nbending_inertia = 10\n{}\n"
                  "[forces]\nlaw = \"friction\"\nstress = {}\nmu = {}\nfull_angle = 0\n"
                  "[time]\nstep = {}\nduration = {}\n",
                  edge_length, motion, string, stress, mu, time_step, duration));
  return read_case(file, {});
}

std::vector<reference::Foot> feet() {
  std::vector<reference::Foot> f;
  for (const double x : {-arm, arm})
    for (const double y : {-arm, arm})
      f.push_back({Vec3(x, y, 0.0), stress * foot_side * foot_side});
  return f;
}

/// What both report of the block at the end.
struct Found {
  Vec3 way = Vec3::Zero(), v = Vec3::Zero();  // m, m/s, of the centre of mass
  double turned = 0.0, speed = 0.0, lost = 0.0, weight = 0.0, torque = 0.0;
};

Found of_program(Case c, const Vec3& v_W) {
  if (v_W.norm() > 0.0) {
    dynamics::DrillingVelocity v;
    v.v_W = v_W;
    v.w_W = c.motion.rotary_speed * Vec3::UnitZ();
    c.drilling.start = dynamics::make_drilling_state(c.drilling.system, Pose{}, v, {});
  }
  Simulation s = start(c);
  const Vec3 from = s.state.drive->state.c_W;
  const double turned = s.state.place.turned;
  while (s.state.steps_done < c.time.steps) step(c, s);
  const Vec3 centre = s.state.drive->state.c_W;
  return {centre - from,
          s.work.velocity.v_W,
          s.state.place.turned - turned,
          s.work.velocity.w_W.z(),
          -s.state.drive->ledger.cut_bit,
          -s.work.loads.force_W.z(),
          -s.work.loads.torque_W.z()};
}

/// `smooth`: m/s, both speeds over which contact is made smooth.
Found of_twin(const Case& c, const Vec3& v_W, double duration, double smooth) {
  const dynamics::DrillingSystem& system = c.drilling.system;
  reference::LumpedState from = reference::lumped_state(system, c.drilling.start);
  if (v_W.norm() > 0.0) from.v_W = v_W;
  const reference::SmoothContact contact{mu, smooth, smooth};
  // The fastest rate is that of all feet crushing, of crushing and of friction, on the lightest way.
  const double rate = 4.0 * stress * foot_side * foot_side / smooth *
                      std::max(1.0 / system.mass, mu * 2.0 * arm * arm / 0.5);
  const int steps = static_cast<int>(std::ceil(duration * rate));
  const auto run = reference::move_on_feet(system, feet(), contact, from, duration, steps);
  const std::vector<double> none(4, -1.0);
  const auto all =
      reference::lumped_forces(system, reference::law_of_feet(feet(), contact, none), run.state);
  const auto string = reference::lumped_forces(system, nullptr, run.state);
  const Vec3 w_W =
      run.state.bit.R_WB * system.gyrostat.carrier_inverse_B * run.state.bit.body_momentum_B;
  return {run.state.c_W - from.c_W,
          run.state.v_W,
          run.state.bit.twist,
          w_W.z(),
          -run.energy.cut_bit,
          -(all.force_W - string.force_W).z(),
          -(all.torque_W - string.torque_W).z()};
}

template <class Of>
std::array<Found, 3> levels(double coarse, const Of& of) {
  return {of(coarse), of(coarse / 2), of(coarse / 4)};
}

TEST(BlockTwin, slides_and_spins) {
  constexpr double until = 0.03, v0 = 0.2;
  const std::string motion = "rotary_speed = \"20 rad/s\"", free = "torsional_stiffness = 0";
  const auto program = levels(1e-3, [&](double h) {
    return of_program(block(motion, free, h, until), Vec3(v0, 0.0, 0.0));
  });
  const Case c = block(motion, free, 1e-3, until);
  const auto twin =
      levels(8e-4, [&](double v) { return of_twin(c, Vec3(v0, 0.0, 0.0), until, v); });
  compare("way", 0, program, twin, [](const Found& f) { return f.way.x(); });
  compare("speed", v0, program, twin, [](const Found& f) { return f.v.x(); });
  compare("turn", 0, program, twin, [](const Found& f) { return f.turned; });
  compare("rotary speed", 20, program, twin, [](const Found& f) { return f.speed; });
  compare("energy spent on the rock", 0, program, twin, [](const Found& f) { return f.lost; });
  compare("weight on the rock", 0, program, twin, [](const Found& f) { return f.weight; });
  compare("torque", 0, program, twin, [](const Found& f) { return f.torque; });
}

/// Friction bears 120 of at most 167 N m.
TEST(BlockTwin, rests_while_its_string_twists_it) {
  constexpr double until = 0.02, torque = 120.0, stiffness = 1000.0;
  const std::string motion = "rotary_speed = 0\ntorque_at_start = 120";
  const std::string string = "torsional_stiffness = 1000";
  const auto program = levels(1e-3, [&](double h) {
    return of_program(block(motion, string, h, until), {0, 0, 0});
  });
  const Case c = block(motion, string, 1e-3, until);
  const auto twin = levels(4e-4, [&](double v) { return of_twin(c, {0, 0, 0}, until, v); });
  compare("weight on the rock", 0, program, twin, [](const Found& f) { return f.weight; });
  compare("torque", 0, program, twin, [](const Found& f) { return f.torque; });
  compare("turn", torque / stiffness, program, twin, [](const Found& f) { return f.turned; });
}

}  // namespace tdbd::simulation::block_twin_test
