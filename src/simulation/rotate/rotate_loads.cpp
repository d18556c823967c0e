#include "simulation/rotate/rotate_loads.hpp"

#include <fmt/format.h>

#include "core/config/csv.hpp"
#include "core/error.hpp"
#include "simulation/case/rotate_settings.hpp"

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

}  // namespace tdbd::simulation
