#include "reference/dynamics/lumped_drilling.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/simulation/coupled/agreement.hpp"
#include "verification/simulation/mesh_bit.hpp"

/// A body in a hole, away from the bottom, as a user would run it, against Runge-Kutta: a wheel that
/// rolls around the wall and advances because it leans, and a mass pressed on a rough wall and pushed
/// along it.
namespace tdbd::simulation::wall_twin_test {

/// A small part high above a flat bottom; `more` are the tables [string] and [wall].
Case in_hole(const std::string& motion, const std::string& more, double time_step,
             double duration) {
  const auto folder = test_folder();
  write_one_part_bit(folder, battery::box({-20, -20, -40}, {20, 20, 0}),
                     "kind = \"gage-pad\"\nupdate_direction = [0, 0, 1]\n");
  const std::string file = write_file(
      folder / "case.toml",
      fmt::format("[bit]\nfile = \"bit.toml\"\n[rock]\nshape = \"flat\"\nradius = \"150 mm\"\n"
                  "wall = \"5 mm\"\nedge_length = \"30 mm\"\nmaterial = \"mancos-shale\"\n"
                  "[motion]\nkind = \"drilling\"\n{}\n{}\n[forces]\nlaw = \"friction\"\n"
                  "stress = 1e6\nmu = 0.3\n[time]\nstep = {}\nduration = {}\n",
                  motion, more, time_step, duration));
  return read_case(file, {});
}

/// What both report at the end, from the start.
struct Found {
  Vec3 c_W = Vec3::Zero(), v_W = Vec3::Zero();  // m, m/s
  Vec3 axis_W = Vec3::Zero();                   // of the body
  double climb = 0.0;                           // m, up
  double screw = 0.0;                           // m, up, of the screw law
  double turned = 0.0, orbited = 0.0;           // rad
  double rubbed = 0.0, lost = 0.0, top = 0.0;   // J
};

/// Adds what the ring went around z, in less than half a turn, and what it advances without slip.
void add_orbit(const dynamics::Wall& wall, const Pose& X_from, const Pose& X_to, Found& f) {
  const Vec3 ring_B(0.0, 0.0, wall.ring_z_B), a = X_from * ring_B, b = X_to * ring_B;
  const double turn = std::atan2(a.x() * b.y() - a.y() * b.x(), a.head<2>().dot(b.head<2>()));
  const Vec3 middle = 0.5 * (a + b), axis = 0.5 * (X_from.R.col(2) + X_to.R.col(2));
  const double e = middle.head<2>().norm();
  const Vec3 around(-middle.y() / e, middle.x() / e, 0.0);
  f.orbited += turn;
  f.screw += axis.dot(around) * turn * (wall.ring_radius + e);
}

/// Gives the bit a velocity at the start, which no key does.
Case thrown(Case c, const Vec3& v_W) {
  dynamics::DrillingVelocity v;
  v.v_W = v_W;
  v.w_W = c.motion.rotary_speed * Vec3::UnitZ();
  c.drilling.start =
      dynamics::make_drilling_state(c.drilling.system, {Mat3::Identity(), c.motion.start_W}, v, {});
  return c;
}

Found of_program(const Case& c) {
  Simulation s = start(c);
  Found f;
  f.climb = s.state.drive->state.c_W.z();
  Pose before = s.state.place.X_WB;
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    add_orbit(c.drilling.system.wall, before, s.state.place.X_WB, f);
    before = s.state.place.X_WB;
  }
  const dynamics::Drilling& d = *s.state.drive;
  f.c_W = d.state.c_W;
  f.climb -= f.c_W.z();
  f.v_W = d.state.momentum_W / c.drilling.system.mass;
  f.axis_W = d.state.rotation.q_WB * Vec3::UnitZ();
  f.turned = s.state.place.turned;
  f.rubbed = d.ledger.wall_friction;
  f.lost = d.ledger.wall_loss;
  f.top = d.ledger.top;
  return f;
}

Pose pose_of(const dynamics::DrillingSystem& system, const reference::LumpedState& s) {
  return {s.bit.R_WB, s.c_W - s.bit.R_WB * system.centre_B};
}

Found of_twin(const Case& c, double duration, int steps) {
  const int stretches = steps / 10;  // after each of which the orbit is followed
  const dynamics::DrillingSystem& system = c.drilling.system;
  reference::LumpedRun run;
  run.state = reference::lumped_state(system, c.drilling.start);
  Found f;
  for (int i = 0; i < stretches; ++i) {
    const Pose before = pose_of(system, run.state);
    run = reference::lumped_drilling_rk4(system, nullptr, run.state, duration * (i + 1) / stretches,
                                         steps / stretches);
    add_orbit(system.wall, before, pose_of(system, run.state), f);
    f.rubbed += run.energy.wall_friction;
    f.lost += run.energy.wall_loss;
    f.top += run.energy.top;
  }
  f.c_W = run.state.c_W;
  f.climb = c.drilling.start.c_W.z() - f.c_W.z();
  f.v_W = run.state.v_W;
  f.axis_W = run.state.bit.R_WB.col(2);
  f.turned = run.state.bit.twist;
  return f;
}

/// It rolls from the start; its centre goes around nearly twice. Dampers resist the orbit below the
/// ring, so that the wheel leans along it and screws itself down against an axial spring. Without slip
/// the way is that of the screw (dynamics, README).
TEST(WallTwin, a_wheel_that_rolls_and_leans_is_a_screw) {
  const std::string motion =
      "rotary_speed = \"6 rad/s\"\nrate_of_penetration = 0\nstart = [0.0052, 0, -0.05]";
  const std::string more =
      "[string]\nmass = 300\ntorsional_inertia = 5\nbending_inertia = 10\n"
      "axial_stiffness = 1e5\naxial_damping = 500\nlateral_damping = 400\n"
      "torsional_stiffness = 1e5\ntorsional_damping = 500\n"
      "bending_stiffness = 3e4\nbending_damping = 3e3\ndampers_to = \"space\"\n"
      "attachment_height = 0\n[wall]\nstiffness = 1e8\nclearance = 0.005\nring_radius = 0.1\n"
      "ring_height = 0.08\nrestitution = 1\nfriction = 0.5\nslip_speed = 0.05\n";
  constexpr double until = 0.1;
  const Vec3 rolling(0.0, -0.6, 0.0);  // m/s
  const auto program = levels(
      [&](int n) { return of_program(thrown(in_hole(motion, more, 2e-4 / n, until), rolling)); });
  const Case c = thrown(in_hole(motion, more, 1e-4, until), rolling);
  const auto twin = levels([&](int n) { return of_twin(c, until, 4000 * n); });
  compare("climb", 0, program, twin, [](const Found& f) { return f.climb; });
  compare("climb over that of the screw", 1, program, twin,
          [](const Found& f) { return f.climb / f.screw; });
  compare("orbit", 0, program, twin, [](const Found& f) { return f.orbited; });
  compare("turn", 0, program, twin, [](const Found& f) { return f.turned; });
  compare("energy rubbed away", 0, program, twin, [](const Found& f) { return f.rubbed; });
  compare("work of the top", 0, program, twin, [](const Found& f) { return f.top; });
  compare("lean", 0, program, twin, [](const Found& f) { return f.axis_W.head<2>().norm(); });
}

/// Pressed by a spring 1 mm beyond the wall and pushed along it by a load above friction, then below.
TEST(WallTwin, a_mass_on_a_rough_wall_is_pushed_by_a_constant_force) {
  for (const double load : {4000.0, 1500.0}) {
    const std::string motion =
        fmt::format("rotary_speed = 0\nweight_on_bit = {}\nstart = [0.002, 0, -0.1]", load);
    const std::string more =
        "[string]\nmass = 500\ntorsional_inertia = 5\nbending_inertia = 10\n"
        "lateral_stiffness = 1e7\nlateral_damping = 2e4\ntorsional_stiffness = 1e4\n"
        "torsional_damping = 100\nbending_stiffness = 1e6\nbending_damping = 1e3\n"
        "attachment_height = 0\n[wall]\nstiffness = 1e8\nclearance = 0.001\nring_radius = 0.1\n"
        "ring_height = 0.03\nrestitution = 1\nfriction = 0.3\nslip_speed = 0.01\n";
    constexpr double until = 0.1;
    const auto program =
        levels([&](int n) { return of_program(in_hole(motion, more, 1e-4 / n, until)); });
    const Case c = in_hole(motion, more, 1e-4, until);
    const auto twin = levels([&](int n) { return of_twin(c, until, 4000 * n); });
    const std::string under = fmt::format(" under {} N", load);
    compare("way" + under, 0, program, twin, [](const Found& f) { return f.c_W.z() + 0.1; });
    compare("rate" + under, 0, program, twin, [](const Found& f) { return f.v_W.z(); });
    compare("depth in the wall" + under, 0, program, twin,
            [](const Found& f) { return f.c_W.x() - 0.001; });
    compare("lean" + under, 0, program, twin, [](const Found& f) { return f.axis_W.x(); });
    compare("energy rubbed away" + under, 0, program, twin,
            [](const Found& f) { return f.rubbed; });
  }
}

}  // namespace tdbd::simulation::wall_twin_test
