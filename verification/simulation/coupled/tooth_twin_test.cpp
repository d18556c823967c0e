#include <numbers>

#include "reference/simulation/pressed_sphere.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/simulation/coupled/agreement.hpp"
#include "verification/simulation/mesh_bit.hpp"

/// One tooth, a ball of 6 mm, that a weight presses into flat rock, and that a string then drags
/// around the hole, against a sphere on flat rock in closed form, moved by Runge-Kutta.
namespace tdbd::simulation::tooth_twin_test {

constexpr double radius = 6e-3, arm = 20e-3, strength = 100e6, mu = 0.3;  // m, m, Pa, 1

/// A ball in mm with its lowest vertex at the origin and `around` meridians.
mesh::TriangleMesh ball(int around) {
  constexpr double pi = std::numbers::pi;
  const int rings = around / 2;
  mesh::TriangleMesh m;
  m.positions.push_back(Vec3::Zero());
  for (int i = 1; i < rings; ++i)
    for (int k = 0; k < around; ++k) {
      const double a = pi * i / rings, b = 2.0 * pi * k / around;
      m.positions.emplace_back(6.0 * std::sin(a) * std::cos(b), 6.0 * std::sin(a) * std::sin(b),
                               6.0 * (std::cos(a) - 1.0));
    }
  m.positions.emplace_back(0.0, 0.0, -12.0);
  const auto at = [&](int ring, int k) { return 1 + (ring - 1) * around + k % around; };
  const int top = static_cast<int>(m.positions.size()) - 1;
  for (int k = 0; k < around; ++k) {
    m.triangles.push_back({0, at(1, k), at(1, k + 1)});
    m.triangles.push_back({top, at(rings - 1, k + 1), at(rings - 1, k)});
    for (int i = 1; i + 1 < rings; ++i) {
      m.triangles.push_back({at(i, k), at(i + 1, k), at(i, k + 1)});
      m.triangles.push_back({at(i, k + 1), at(i + 1, k), at(i + 1, k + 1)});
    }
  }
  return m;
}

/// `n`: refinement of rock, time and ball together.
Case tooth(const std::string& motion, int meridians, int n, double edge_length, double time_step,
           double duration) {
  const auto folder = test_folder();
  mesh::write_mesh(folder / "ball.off", ball(meridians * n));
  write_file(folder / "bit.toml",
             fmt::format("name = \"tooth\"\n[[parts]]\nname = \"ball\"\nkind = \"tooth\"\n"
                         "file = \"ball.off\"\nposition = [{}, 0, 0]\n"
                         "update_direction = [0, 0, 1]\n",
                         arm));
  const std::string file = write_file(
      folder / "case.toml",
      fmt::format("[bit]\nfile = \"bit.toml\"\n[rock]\nshape = \"flat\"\nradius = \"30 mm\"\n"
                  "wall = \"2 mm\"\nedge_length = {}\n[rock.material]\nname = \"made up\"\n"
                  "unconfined_strength = {}\nfriction_angle = 0\n"
                  "[motion]\nkind = \"drilling\"\nweight_on_bit = 6000\nrate_memory = 0\n{}\n"
                  "[string]\nmass = 200\ntorsional_inertia = 1\nbending_inertia = 5\n"
                  "lateral_stiffness = 1e7\nlateral_damping = 2e4\naxial_damping = 4e4\n"
                  "torsional_stiffness = 2e4\ntorsional_damping = 200\n"
                  "bending_stiffness = 1e6\nbending_damping = 1e3\nattachment_height = 0\n"
                  "[forces]\nlaw = \"indentation\"\nmu = {}\n"
                  "[time]\nstep = {}\nduration = {}\n",
                  edge_length / n, strength, motion, mu, time_step / n, duration));
  return read_case(file, {});
}

/// What both report at the end.
struct Found {
  double depth = 0.0, rate = 0.0, turned = 0.0, lean = 0.0;  // m, m/s, rad, 1
  double weight = 0.0, torque = 0.0, spent = 0.0;            // N, N m, J
};

Found of_program(const Case& c) {
  Simulation s = start(c);
  const double from = s.state.drive->state.c_W.z();
  while (s.state.steps_done < c.time.steps) step(c, s);
  const dynamics::Drilling& d = *s.state.drive;
  return {d.state.c_W.z() - from,    d.state.momentum_W.z() / c.drilling.system.mass,
          s.state.place.turned,      (d.state.rotation.q_WB * Vec3::UnitZ()).head<2>().norm(),
          -s.work.loads.force_W.z(), -s.work.loads.torque_W.z(),
          -d.ledger.cut_bit};
}

Found of_twin(const Case& c, double duration, double smooth, int steps) {
  const dynamics::DrillingSystem& system = c.drilling.system;
  const reference::SphericalTooth tooth{
      Vec3(arm, 0.0, -radius), radius, strength, {mu, smooth, smooth}, steps / 50};
  const reference::LumpedLaw law = reference::law_of_tooth(tooth);
  const reference::LumpedState from = reference::lumped_state(system, c.drilling.start);
  const auto run = reference::lumped_drilling_rk4(system, law, from, duration, steps);
  const auto all = reference::lumped_forces(system, law, run.state);
  const auto string = reference::lumped_forces(system, nullptr, run.state);
  const Vec3 force_W = all.force_W - string.force_W, torque_W = all.torque_W - string.torque_W;
  const Vec3 centre_W = run.state.bit.R_WB * system.centre_B;  // from the bit's origin
  return {run.state.c_W.z() - from.c_W.z(),
          run.state.v_W.z(),
          run.state.bit.twist,
          run.state.bit.R_WB.col(2).head<2>().norm(),
          -force_W.z(),
          -(torque_W + centre_W.cross(force_W)).z(),
          -run.energy.cut_bit};
}

TEST(ToothTwin, is_pressed_in_by_its_weight) {
  constexpr double until = 0.02;
  const auto program = levels(
      [&](int n) { return of_program(tooth("rotary_speed = 0", 32, n, 1.2e-3, 1e-3, until)); });
  const Case c = tooth("rotary_speed = 0", 32, 1, 1.2e-3, 1e-3, until);
  const auto twin = levels([&](int n) { return of_twin(c, until, 2e-3 / n, 2000 * n); });
  compare("depth", 0, program, twin, [](const Found& f) { return f.depth; });
  compare("rate", 0, program, twin, [](const Found& f) { return f.rate; });
  compare("weight", 0, program, twin, [](const Found& f) { return f.weight; });
  compare("energy spent on the rock", 0, program, twin, [](const Found& f) { return f.spent; });
}

TEST(ToothTwin, is_dragged_under_its_weight) {
  constexpr double until = 0.05;
  const std::string turning = "rotary_speed = \"6 rad/s\"";
  const auto program =
      levels([&](int n) { return of_program(tooth(turning, 24, n, 1.2e-3, 1e-3, until)); });
  const Case c = tooth(turning, 24, 1, 1.2e-3, 1e-3, until);
  const auto twin = levels([&](int n) { return of_twin(c, until, 2e-3 / n, 4000 * n); });
  compare("depth", 0, program, twin, [](const Found& f) { return f.depth; });
  compare("turn", 0, program, twin, [](const Found& f) { return f.turned; });
  compare("weight", 0, program, twin, [](const Found& f) { return f.weight; });
  compare("torque", 0, program, twin, [](const Found& f) { return f.torque; });
  compare("lean", 0, program, twin, [](const Found& f) { return f.lean; });
  compare("energy spent on the rock", 0, program, twin, [](const Found& f) { return f.spent; });
}

}  // namespace tdbd::simulation::tooth_twin_test
