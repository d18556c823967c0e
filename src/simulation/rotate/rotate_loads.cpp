#include "simulation/rotate/rotate_loads.hpp"

#include <fmt/format.h>

#include "core/config/csv.hpp"
#include "core/error.hpp"

namespace tdbd::simulation {
namespace {

using dynamics::TorqueFrame;

const Vec3 zero = Vec3::Zero();

TorqueFrame read_frame(Config& c) {
  return c.choice<TorqueFrame>(
      "frame", {{"body", TorqueFrame::body}, {"space", TorqueFrame::space}}, TorqueFrame::body);
}

/// A direction, made unit.
Vec3 read_direction(Config& c, const char* key, const Vec3& fallback) {
  const Vec3 v = c.vector(key, "1", fallback);
  if (v.norm() > 0.0) return v.stableNormalized();
  c.problem(key, fmt::format("an arm of length {}", v.norm()), "a direction");
  return fallback;
}

/// Three numbers, none negative.
Vec3 read_coefficients(Config& c, const char* key, const std::string& unit) {
  const Vec3 v = c.vector(key, unit, zero);
  if ((v.array() < 0.0).any())
    c.problem(key, fmt::format("{}", v.minCoeff()), "numbers that are not negative");
  return v;
}

dynamics::HarmonicTorque read_harmonic(Config c) {
  dynamics::HarmonicTorque h;
  h.frame = read_frame(c);
  h.amplitude = c.vector("amplitude", "N m", std::nullopt);
  h.angular_frequency = c.quantity("angular_frequency", "rad/s", 0.0, Range::non_negative());
  h.phase = c.quantity("phase", "rad", 0.0);
  return h;
}

dynamics::SampledTorque read_samples(Config c) {
  const TorqueFrame frame = read_frame(c);
  const std::string file = c.path("file", std::nullopt);
  if (file.empty()) return {};
  try {
    return read_torque_samples(file, frame);
  } catch (const InputError& e) {
    c.other_file(e.what());
    return {};
  }
}

dynamics::ConeLoad read_cone_load(Config c) {
  dynamics::ConeLoad load;
  load.internal = c.quantity("torque", "N m", 0.0);
  load.external = c.quantity("external_torque", "N m", 0.0);
  load.damping = c.quantity("damping", "N m s/rad", 0.0, Range::non_negative());
  return load;
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
  Config load = c.table("load");
  dynamics::Loads l;
  l.body_torque_B = load.vector("body_torque", "N m", zero);
  l.space_torque_W = load.vector("space_torque", "N m", zero);
  l.gravity_moment = load.quantity("gravity_moment", "N m", 0.0);
  l.gravity_arm_B = read_direction(load, "gravity_arm", Vec3::UnitZ());
  l.stiffness_W = read_coefficients(load, "stiffness", "N m/rad");
  l.damping_W = read_coefficients(load, "damping", "N m s/rad");
  for (Config& h : load.tables("harmonics")) l.harmonics.push_back(read_harmonic(h));
  for (Config& s : load.tables("samples")) l.samples.push_back(read_samples(s));
  for (Config& cone : c.tables("cones")) l.cones.push_back(read_cone_load(cone));
  return l;
}

}  // namespace tdbd::simulation
