#include "simulation/rotate/rotate_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bit/bit.hpp"
#include "bit/files/file_checks.hpp"
#include "core/config/csv.hpp"
#include "core/error.hpp"
#include "core/provenance.hpp"
#include "core/tolerance.hpp"
#include "dynamics/momenta.hpp"
#include "mesh/files/files.hpp"
#include "rotation/screw.hpp"
#include "simulation/case/rotate_settings.hpp"
#include "simulation/case/run_settings.hpp"

namespace tdbd::simulation {
namespace {

using dynamics::TorqueFrame;

/// Reads the direction of the arm and normalizes it.
Vec3 unit_arm(Config& c, const Vec3& v) {
  if (v.norm() > 0.0) return v.stableNormalized();
  c.problem("gravity_arm", fmt::format("an arm of length {}", v.norm()), "a direction");
  return Vec3::UnitZ();
}

/// Reads three numbers, which must not be negative.
void check_coefficients(Config& c, const char* key, const Vec3& v) {
  if ((v.array() < 0.0).any())
    c.problem(key, fmt::format("{}", v.minCoeff()), "numbers that are not negative");
}

dynamics::SampledTorque read_samples(Config& c) {
  SampleSettings s;
  read_fields(c, s);
  if (s.file.empty()) return {};
  try {
    return read_torque_samples(s.file, s.frame);
  } catch (const InputError& e) {
    c.other_file(e.what());
    return {};
  }
}

}  // namespace

dynamics::SampledTorque read_torque_samples(const std::string& file, TorqueFrame frame) {
  const CsvTable t = read_csv(file);
  const std::size_t time = csv_column(t, "time_s"), x = csv_column(t, "x"), y = csv_column(t, "y"),
                    z = csv_column(t, "z");
  dynamics::SampledTorque s{frame, {}, {}};
  for (std::size_t i = 0; i < t.rows.size(); ++i) {
    const std::vector<double>& row = t.rows[i];
    if (i > 0 && !(row[time] > s.times.back()))
      throw InputError(fmt::format("{}:{}: time_s: found {} after {}, expected rising times", file,
                                   t.lines[i], row[time], s.times.back()));
    s.times.push_back(row[time]);
    s.torques.emplace_back(row[x], row[y], row[z]);
  }
  if (s.times.empty())
    throw InputError(fmt::format("{}: found no rows, expected at least one", file));
  return s;
}

dynamics::Loads read_loads(Config& c) {
  dynamics::Loads l = read_table<LoadSettings>(c).loads;
  Config load = c.table(LoadSettings::table);
  l.gravity_arm_B = unit_arm(load, l.gravity_arm_B);
  check_coefficients(load, "stiffness", l.stiffness_W);
  check_coefficients(load, "damping", l.damping_W);
  for (Config& table : load.tables(HarmonicSettings::table)) {
    HarmonicSettings harmonic;
    read_fields(table, harmonic);
    l.harmonics.push_back(harmonic.torque);
  }
  for (Config& table : load.tables(SampleSettings::table)) l.samples.push_back(read_samples(table));
  return l;
}

namespace {

using dynamics::InertiaCheck;

/// rad. Around this angle, adjacent doubles are still only about a thousandth of a turn apart.
constexpr double most_turned = 1e13;

/// Computes the inertia of a solid of uniform density about its centre of mass, along the axes of
/// its file.
Mat3 mesh_inertia(Config& c, const BodySettings& s) {
  if (s.mesh.empty() || bit::contradicts_unit(c, s.mesh, s.unit)) return Mat3::Identity();
  try {
    const mesh::TriangleMesh m = mesh::read_mesh(s.mesh, s.unit);
    const std::size_t mistakes = c.problem_count();
    bit::report_mesh_faults(c, "mesh", s.mesh, {{"body", m}},
                            "a closed mesh whose triangles face outward");
    if (s.unit_check) bit::unit_error(c, "unit", m, s.unit, bit::body_along);
    if (c.problem_count() == mistakes) return bit::mass_properties(m, s.density).inertia;
  } catch (const InputError& e) {
    c.problem("mesh", e.what(), "a mesh that can be read");
  }
  return Mat3::Identity();
}

/// Returns how far a matrix deviates from a rotation.
double rotation_defect(const Mat3& R) {
  const double defect = (R.transpose() * R - Mat3::Identity()).cwiseAbs().maxCoeff();
  return R.determinant() > 0.0 ? defect : std::max(defect, 2.0);
}

/// Reads the attitude, bit to space: a rotation vector or a matrix.
Mat3 attitude_of(Config& c, const BodySettings& s) {
  if (!c.has("attitude")) {
    const Vec3& r = s.rotation_vector;
    if (r.stableNorm() <= most_turned) return rotation::exp(r);
    c.problem("rotation_vector", fmt::format("an angle of {:.3g} rad", r.stableNorm()),
              fmt::format("at most {:.0e} rad, beyond which no digit of an attitude is left",
                          most_turned));
    return Mat3::Identity();
  }
  if (c.has("rotation_vector")) {
    c.problem("attitude", "rotation_vector as well", "one of the two");
  } else if (const double defect = rotation_defect(s.attitude); defect > tolerance::rotation) {
    c.problem("attitude", fmt::format("a matrix that misses a rotation by {:.3g}", defect),
              fmt::format("a rotation to {}", tolerance::rotation));
    return Mat3::Identity();
  }
  return s.attitude;
}

/// Cones, their initial state and the loads on them.
struct Cones {
  std::vector<dynamics::Cone> cones;
  std::vector<double> spins, angles;
  std::vector<dynamics::ConeLoad> loads;
};

Cones read_cones(Config& c) {
  Cones all;
  for (Config table : c.tables(ConeSettings::table)) {
    ConeSettings s;
    read_fields(table, s);
    if (!(s.cone.axis_B.norm() > 0.0))
      table.problem("axis", fmt::format("an axis of length {}", s.cone.axis_B.norm()),
                    "a direction");
    all.cones.push_back(s.cone);
    all.spins.push_back(s.spin);
    all.angles.push_back(s.angle);
    all.loads.push_back(s.load);
  }
  return all;
}

/// Records the inertia problem `why` at the key that causes it: that of the body alone, of one cone
/// alone, or of all cones together.
void report_inertia_problem(Config& c, const std::string& why, const Mat3& inertia,
                            const std::vector<dynamics::Cone>& cones, InertiaCheck check) {
  const std::string expected =
      check == InertiaCheck::on
          ? "what a body can have (body.check = \"off\" admits the inertias of published "
            "benchmarks that no body has)"
          : "a positive definite inertia, also without the cones' axial inertias";
  if (const std::string alone = dynamics::inertia_problem(inertia, {}, check); !alone.empty())
    return c.problem(c.has("body.mesh") ? "body.mesh" : "body.inertia", alone, expected);
  for (std::size_t k = 0; k < cones.size(); ++k)
    if (const std::string one = dynamics::inertia_problem(inertia, {cones[k]}, check); !one.empty())
      return c.problem(fmt::format("cones[{}].axial_inertia", k),
                       fmt::format("{} kg m2: {}", cones[k].axial_inertia, one), expected);
  c.problem("cones", why, expected);
}

/// Records, at the key that causes it, that the energy at the start is not finite.
void report_infinite_energy(Config& c, const dynamics::Gyrostat& body, const Vec3& w_B,
                            const std::vector<double>& spins) {
  constexpr const char* found = "a kinetic energy that is not finite";
  constexpr const char* expected = "numbers whose squares and inverses are numbers";
  if (!std::isfinite(w_B.squaredNorm())) return c.problem("body.angular_velocity", found, expected);
  for (std::size_t k = 0; k < spins.size(); ++k) {
    if (!std::isfinite(spins[k] * spins[k]))
      return c.problem(fmt::format("cones[{}].spin", k), found, expected);
    if (!std::isfinite(1.0 / body.cones[k].axial_inertia))
      return c.problem(fmt::format("cones[{}].axial_inertia", k), found, expected);
  }
  c.problem(c.has("body.mesh") ? "body.mesh" : "body.inertia", found, expected);
}

}  // namespace

BodyStart read_body_start(Config& c) {
  const std::size_t mistakes = c.problem_count();
  const auto settings = read_table<BodySettings>(c);
  Config body = c.table(BodySettings::table);
  const Mat3 inertia = body.has("mesh") ? mesh_inertia(body, settings) : settings.inertia;
  const InertiaCheck check = settings.check;
  const Mat3 R_WB = attitude_of(body, settings);
  const Vec3& w_B = settings.angular_velocity;
  const Cones cones = read_cones(c);
  if (c.problem_count() != mistakes) return {};
  if (const std::string why = dynamics::inertia_problem(inertia, cones.cones, check);
      !why.empty()) {
    report_inertia_problem(c, why, inertia, cones.cones, check);
    return {};
  }
  BodyStart start{dynamics::make_gyrostat(inertia, cones.cones, check), {}, cones.loads};
  start.state = dynamics::make_state(start.body, R_WB, w_B, cones.spins, cones.angles);
  if (!std::isfinite(dynamics::kinetic_energy(start.body, start.state)))
    report_infinite_energy(c, start.body, w_B, cones.spins);
  return start;
}

namespace {

using dynamics::Drift;

/// Relative tolerance, in steps, within which a duration is a whole number of steps.
constexpr double whole_steps = 1e-6;

dynamics::Integrator read_integrator(Config& whole) {
  const dynamics::Integrator i = read_table<IntegratorSettings>(whole).integrator;
  if (i.order % 2 != 0)
    whole.table(IntegratorSettings::table)
        .problem("order", fmt::format("{}", i.order), "2, 4, 6 or 8");
  return i;
}

void doubt_step(Config& whole, RotateCase& r) {
  constexpr double largest_turn = largest_turn_in_step;
  r.place_of_step = whole.table(RotateTimeSettings::table).place("step");
  const double speed = dynamics::angular_velocity(r.body, r.start).norm();
  if (!(speed * r.time.step > largest_turn)) return;
  const std::string key = "step", table(RotateTimeSettings::table.name);
  r.warnings.push_back(
      {r.place_of_step, table + "." + key,
       fmt::format("the body turns by {:.3g} rad in a step of {:.3g} s at the start; for "
                   "meaningful results use at most {} rad: {:.2g} s",
                   speed * r.time.step, r.time.step, largest_turn, largest_turn / speed)});
}

}  // namespace

RotateTime read_rotate_time(Config& whole) {
  constexpr double most_steps = 1e15;
  const auto settings = read_table<RotateTimeSettings>(whole);
  Config c = whole.table(RotateTimeSettings::table);
  RotateTime t{settings.step, settings.duration};
  if (!c.has("step") || !c.has("duration")) return t;
  const double ratio = t.duration / t.step;
  if (ratio < 1.0 - whole_steps)
    c.problem("step", fmt::format("{} s for a run of {} s", t.step, t.duration),
              "at most the duration");
  if (ratio > most_steps)
    c.problem("step", fmt::format("{} s, which makes {:.3g} steps", t.step, ratio),
              fmt::format("at most {} steps", most_steps));
  t.steps = std::lround(std::clamp(ratio, 1.0, most_steps));
  if (std::abs(ratio - static_cast<double>(t.steps)) <= whole_steps) return t;
  t.steps = std::lround(std::ceil(std::clamp(ratio, 1.0, most_steps)));
  t.step = t.duration / static_cast<double>(t.steps);
  return t;
}

std::string drift_name(Drift drift) {
  for (const auto& named : IntegratorSettings::drifts)
    if (named.value == drift && !named.name.empty()) return std::string(named.name);
  return "";
}

bool is_rotate_case(const std::string& path) {
  return Config::read_file(path, {}).has(BodySettings::table);
}

RotateCase read_rotate_case(const std::string& path, const std::vector<std::string>& overrides) {
  Config c = Config::read_file(path, overrides);
  RotateCase r;
  r.path = path;
  TitleSettings title;
  read_fields(c, title);
  r.title = title.title;
  BodyStart start = read_body_start(c);
  r.loads = read_loads(c);
  r.loads.cones = std::move(start.cone_loads);
  r.integrator = read_integrator(c);
  r.time = read_rotate_time(c);
  const auto output =
      read_table(c, RotateOutput{.history_every = usual_history_every(r.time.steps)});
  r.history_every = output.history_every;
  r.checkpoint_every = output.checkpoint_every;
  c.finish();
  r.body = std::move(start.body);
  r.start = std::move(start.state);
  r.files = c.files();
  r.resolved = c.resolved();
  r.hash = fnv1a_hex(c.fingerprint());
  r.quantities = c.quantities();
  doubt_step(c, r);
  return r;
}

}  // namespace tdbd::simulation
