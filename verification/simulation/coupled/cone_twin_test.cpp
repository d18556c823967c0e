#include "dynamics/momenta.hpp"
#include "reference/simulation/rolled_bit.hpp"
#include "verification/simulation/coupled/agreement.hpp"
#include "verification/simulation/coupled/pdc_twin.hpp"
#include "verification/simulation/mesh_bit.hpp"

/// A cone with one row of spherical teeth that rolls around the hole on flat rock, and bounces there
/// from tooth to tooth, against spheres on a grid of heights, moved by Runge-Kutta.
namespace tdbd::simulation::cone_twin_test {

constexpr double R = 40e-3, rho = 20e-3, tooth_radius = 3e-3;  // m: of the tips; of the teeth
constexpr double strength = 100e6, mu = 0.3;                   // Pa, 1
constexpr int teeth = 10;

/// Rock and time `n` times finer than 1 mm and `step` (s). With n the error of the facets halves, too:
/// it is of second order, and 40 is the most of them. With 44 a ball has more planes than a part's solid
/// may have (mesh::most_planes). The faceted balls are larger by the share that
/// gives them the sphere's section at a depth of half their radius, to second order in the facets.
Case light_cone(const std::string& motion, const std::string& string, int n, double step,
                double duration) {
  const int facets = n == 1 ? 20 : n == 2 ? 28 : 40;
  const double radius = tooth_radius * (1.0 + std::pow(full_turn / facets, 2) / 3.0);
  const auto folder = test_folder();
  write_file(folder / "wheel.toml",
             fmt::format("name = \"wheel\"\n[journal]\nangle = 0\noffset = 0\nskew = 0\n"
                         "apex = {0}\n[teeth]\nkind = \"hemispherical\"\ndiameter = {3}\n"
                         "protrusion = 0.007\nembedding = 0.001\n[mesh]\nfacets = {1}\n[[cones]]\n"
                         "azimuth = 0.3\nshell = [[-0.004, 0.013], [0.004, 0.013]]\n"
                         "[[cones.rows]]\ns = 0\nteeth = {2}\n",
                         -R, facets, teeth, 2.0 * radius));
  const std::string file = write_file(
      folder / "case.toml",
      fmt::format("[bit]\nfile = \"wheel.toml\"\n[rock]\nshape = \"flat\"\nradius = \"50 mm\"\n"
                  "wall = \"20 mm\"\nedge_length = {}\n[rock.material]\nname = \"made up\"\n"
                  "unconfined_strength = {}\nfriction_angle = 0\n"
                  "[motion]\nkind = \"drilling\"\n{}\n"
                  "[string]\nmass = 200\ntorsional_inertia = 2\nbending_inertia = 5\n"
                  "lateral_stiffness = 1e9\nlateral_damping = 2e5\ntorsional_stiffness = 2e4\n"
                  "torsional_damping = 200\nbending_stiffness = 1e7\nbending_damping = 1e4\n"
                  "attachment_height = 0\n{}\n"
                  "[forces]\nlaw = \"indentation\"\nmu = {}\n[time]\nstep = {}\nduration = {}\n",
                  1e-3 / n, strength, motion, string, mu, step / n, duration));
  return read_case(file, {});
}

/// The same with a cone that is heavier than any material makes it: a light one follows friction within
/// a microsecond, which Runge-Kutta would have to resolve.
Case cone(const std::string& motion, const std::string& string, int n, double step,
          double duration) {
  constexpr double axial_inertia = 0.01;  // kg m2
  Case c = light_cone(motion, string, n, step, duration);
  dynamics::DrillingSystem& system = c.drilling.system;
  dynamics::Cone wheel = system.gyrostat.cones[0];
  const double more = axial_inertia - wheel.axial_inertia;
  wheel.axial_inertia = axial_inertia;
  system.gyrostat = dynamics::make_gyrostat(
      system.gyrostat.inertia_B + more * wheel.axis_B * wheel.axis_B.transpose(), {wheel});
  const double speed = c.motion.rotary_speed;
  const std::vector<double> spins{-R / rho * speed}, angles{0.0};
  c.drilling.start.rotation =
      dynamics::make_state(system.gyrostat, Mat3::Identity(), speed * Vec3::UnitZ(), spins, angles);
  return c;
}

/// What both report: at the end, and means and extremes over the second half.
struct Found {
  std::vector<double> depth, turned;     // m, rad, at equal times
  double rolled = 0.0, spent = 0.0;      // rad, J
  double weight = 0.0, torque = 0.0;     // N, N m, means
  double highest = 1.0, deepest = -1.0;  // m
  double off = 0.0;                      // 1, share of time off the rock
};

/// Adds a step of the second half.
void add_mean(double share, double depth, double weight, double torque, Found& f) {
  f.weight += share * weight;
  f.torque += share * torque;
  if (weight == 0.0) f.off += share;
  f.highest = std::min(f.highest, depth);
  f.deepest = std::max(f.deepest, depth);
}

/// A row after each of 20 equal parts of a run of so many steps.
void add_row(long done, long steps, double depth, double turned, Found& f) {
  if (done * 20 / steps == static_cast<long>(f.depth.size())) return;
  f.depth.push_back(depth);
  f.turned.push_back(turned);
}

Found of_program(const Case& c) {
  Simulation s = start(c);
  Found f;
  const double from = s.state.drive->state.c_W.z();
  const long half = c.time.steps / 2;
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    add_row(s.state.steps_done, c.time.steps, s.state.drive->state.c_W.z() - from,
            s.state.place.turned, f);
    if (s.state.steps_done > half)
      add_mean(1.0 / static_cast<double>(c.time.steps - half), s.state.drive->state.c_W.z() - from,
               -s.work.loads.force_W.z(), -s.work.loads.torque_W.z(), f);
  }
  f.rolled = -s.state.cones[0].angle;
  f.spent = -s.state.drive->ledger.cut_bit;
  return f;
}

Found of_twin(const Case& c, double duration, double smooth, double grid, double h) {
  const dynamics::DrillingSystem& system = c.drilling.system;
  reference::RolledBit bit;
  reference::RolledCone wheel{c.bit.cones[0].X_BK, system.gyrostat.cones[0].axial_inertia, {}};
  for (int i = 0; i < teeth; ++i) {
    const double a = full_turn * i / teeth;
    wheel.centres_K.emplace_back((rho - tooth_radius) * Vec3(std::cos(a), std::sin(a), 0.0));
  }
  bit.cones.push_back(wheel);
  bit.tooth_radius = tooth_radius;
  bit.pressure = strength;
  bit.contact = {mu, smooth, smooth};
  bit.carrier_inertia = system.gyrostat.carrier_B(2, 2);
  const reference::AxialString string = axial_string(c);
  reference::RolledState s;
  s.momentum = bit.carrier_inertia * string.speed;
  s.angles = {0.0};
  s.spins = {-R / rho * string.speed * wheel.axial_inertia};
  reference::RockGrid rock(R + 2 * tooth_radius, grid);
  Found f;
  const long steps = std::lround(duration / h), half = steps / 2;
  for (long i = 1; i <= steps; ++i) {
    reference::roll(bit, string, h, rock, s);
    add_row(i, steps, s.height, s.turned, f);
    if (i <= half) continue;
    const reference::RolledLoads loads = reference::rolled_loads(bit, rock, s);
    add_mean(1.0 / static_cast<double>(steps - half), s.height, loads.weight, loads.torque, f);
  }
  f.rolled = -s.angles[0];
  f.spent = s.spent;
  return f;
}

TEST(ConeTwin, rolls_on_flat_rock) {
  constexpr double step = 4e-4, until = 0.1;  // s
  const std::string motion = "rotary_speed = \"60 rpm\"\nweight_on_bit = 1500\nrate_memory = 0";
  const std::string string = "axial_damping = 2e4";
  const auto program =
      levels([&](int n) { return of_program(cone(motion, string, n, step, until)); });
  const Case c = cone(motion, string, 1, step, until);
  const auto twin = levels([&](int n) { return of_twin(c, until, 8e-3 / n, 4e-4 / n, 4e-5 / n); });
  compare_ways("depth", 2e-3, program, twin, &Found::depth);
  compare_ways("turn of the bit", 0.6, program, twin, &Found::turned);
  compare("turn of the cone", 0, program, twin, [](const Found& f) { return f.rolled; });
  compare("weight", 0, program, twin, [](const Found& f) { return f.weight; });
  compare("torque", 0, program, twin, [](const Found& f) { return f.torque; });
  compare("energy spent on the rock", 0, program, twin, [](const Found& f) { return f.spent; });
}

/// Without a damper the bit leaves the rock for an eighth of the time. The share of time is a severity,
/// whose uncertainty may be 5 %.
TEST(ConeTwin, bounces_from_tooth_to_tooth) {
  constexpr double step = 2e-4, until = 0.1, print = 2e-3;  // s; m, about the deepest
  const std::string motion = "rotary_speed = \"180 rpm\"\nweight_on_bit = 800\nrate_memory = 0";
  const auto program = levels([&](int n) { return of_program(cone(motion, "", n, step, until)); });
  const Case c = cone(motion, "", 1, step, until);
  const auto twin = levels([&](int n) { return of_twin(c, until, 8e-3 / n, 4e-4 / n, 4e-5 / n); });
  compare_ways("depth", print, program, twin, &Found::depth);
  compare("highest", print, program, twin, [](const Found& f) { return f.highest; });
  compare("deepest", print, program, twin, [](const Found& f) { return f.deepest; });
  compare("turn of the cone", 0, program, twin, [](const Found& f) { return f.rolled; });
  compare("weight", 0, program, twin, [](const Found& f) { return f.weight; });
  compare(
      "share of time off the rock", 1, program, twin, [](const Found& f) { return f.off; }, 0.05);
  compare("energy spent on the rock", 0, program, twin, [](const Found& f) { return f.spent; });
}

}  // namespace tdbd::simulation::cone_twin_test
