#include "simulation/rotate/rotate_loads.hpp"

#include <fmt/format.h>

#include "core/config/csv.hpp"
#include "core/error.hpp"
#include "simulation/case/rotate_keys.hpp"

namespace tdbd::simulation {
namespace {

using dynamics::TorqueFrame;

/// Reads the direction of the arm and normalizes it.
Vec3 read_arm(Config& c) {
  const VectorKey& key = load_keys::gravity_arm;
  const Vec3 v = c.read(key);
  if (v.norm() > 0.0) return v.stableNormalized();
  c.problem(key, fmt::format("an arm of length {}", v.norm()), "a direction");
  return Vec3::UnitZ();
}

/// Reads three numbers, which must not be negative.
Vec3 read_coefficients(Config& c, const VectorKey& key) {
  const Vec3 v = c.read(key);
  if ((v.array() < 0.0).any())
    c.problem(key, fmt::format("{}", v.minCoeff()), "numbers that are not negative");
  return v;
}

dynamics::HarmonicTorque read_harmonic(Config c) {
  using namespace harmonic_keys;
  return {c.read(frame), c.read(amplitude), c.read(angular_frequency), c.read(phase)};
}

dynamics::SampledTorque read_samples(Config c) {
  const TorqueFrame frame = c.read(sample_keys::frame);
  const std::string file = c.read(sample_keys::file);
  if (file.empty()) return {};
  try {
    return read_torque_samples(file, frame);
  } catch (const InputError& e) {
    c.other_file(e.what());
    return {};
  }
}

dynamics::ConeLoad read_cone_load(Config c) {
  using namespace cone_keys;
  return {c.read(torque), c.read(external_torque), c.read(damping)};
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
  Config load = c.table(load_keys::table);
  dynamics::Loads l;
  l.body_torque_B = load.read(load_keys::body_torque);
  l.space_torque_W = load.read(load_keys::space_torque);
  l.gravity_moment = load.read(load_keys::gravity_moment);
  l.gravity_arm_B = read_arm(load);
  l.stiffness_W = read_coefficients(load, load_keys::stiffness);
  l.damping_W = read_coefficients(load, load_keys::damping);
  for (Config& h : load.tables(harmonic_keys::table)) l.harmonics.push_back(read_harmonic(h));
  for (Config& s : load.tables(sample_keys::table)) l.samples.push_back(read_samples(s));
  for (Config& cone : c.tables(cone_keys::table)) l.cones.push_back(read_cone_load(cone));
  return l;
}

}  // namespace tdbd::simulation
