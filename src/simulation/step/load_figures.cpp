#include "simulation/step/load_figures.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

namespace tdbd::simulation {
namespace {

using Json = nlohmann::ordered_json;

Json part_json(const PartLoadFigures& p) {
  return {{"name", p.name},
          {"normal_mean_n", p.normal.mean},
          {"normal_std_n", p.normal.deviation},
          {"tangential_mean_n", p.tangential.mean},
          {"tangential_std_n", p.tangential.deviation},
          {"power_mean_w", p.power},
          {"removed_volume_m3", p.removed},
          {"specific_energy_pa", p.specific_energy}};
}

}  // namespace

/// Keys are those of the means.
Json uncertainty_json(const SamplingUncertainty& u) {
  const auto known = [](const std::optional<double>& x) { return x ? Json(*x) : Json(); };
  return {{"wob_mean_n", known(u.wob)},
          {"tob_mean_n_m", known(u.tob)},
          {"rop_mean_m_per_s", known(u.rop)},
          {"rotary_speed_mean_rad_per_s", known(u.rotary_speed)},
          {"of", "sampling"},
          {"coverage", sampling_coverage}};
}

Json to_json(const LoadStatisticsSummary& f) {
  Json parts = Json::array();
  for (const PartLoadFigures& p : f.parts) parts.push_back(part_json(p));
  const auto known = [&f](double x) { return f.steps > 0 ? Json(x) : Json(); };
  return {{"means_from_s", known(f.from)},
          {"means_to_s", known(f.to)},
          {"wob_mean_n", known(f.wob.mean)},
          {"wob_std_n", known(f.wob.deviation)},
          {"tob_mean_n_m", known(f.tob.mean)},
          {"tob_std_n_m", known(f.tob.deviation)},
          {"rop_mean_m_per_s", known(f.rop.mean)},
          {"rop_std_m_per_s", known(f.rop.deviation)},
          {"rotary_speed_mean_rad_per_s", known(f.rotary_speed.mean)},
          {"rotary_speed_std_rad_per_s", known(f.rotary_speed.deviation)},
          {"uncertainty", uncertainty_json(f.uncertainty)},
          {"aggressiveness", known(f.aggressiveness)},
          {"mechanical_specific_energy_pa", known(f.specific_energy)},
          {"imbalance", known(f.imbalance)},
          {"imbalance_azimuth_rad", known(f.imbalance_azimuth)},
          {"drilling_power_mean_w", known(f.power)},
          {"forces", parts}};
}

namespace {

void add_parts(const LoadedStep& step, LoadStatistics& s) {
  const std::size_t count = step.loads.parts.size();
  s.normal.resize(count);
  s.tangential.resize(count);
  s.part_energy.resize(count, 0.0);
  s.part_removed.resize(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const PartLoad& p = step.loads.parts[i];
    add(s.normal[i], p.normal);
    add(s.tangential[i], p.tangential);
    s.part_energy[i] += p.power * step.dt;
    s.part_removed[i] += step.removed_by_part[i];
  }
}

/// x / y, or 0 if y is 0.
double quotient(double x, double y) { return y != 0.0 ? x / y : 0.0; }

/// Volume removed by the whole cutter of a part, m3. The part that captures a vertex depends on the
/// mesh.
double removed_by_cutter(const bit::Bit& bit, const LoadStatistics& s, std::size_t part) {
  if (bit.parts[part].cutter < 0) return s.part_removed[part];
  double removed = 0.0;
  for (std::size_t i = 0; i < s.part_removed.size(); ++i)
    if (bit.parts[i].cutter == bit.parts[part].cutter) removed += s.part_removed[i];
  return removed;
}

std::vector<PartLoadFigures> part_figures(const bit::Bit& bit, const LoadStatistics& s) {
  std::vector<PartLoadFigures> parts;
  for (std::size_t i = 0; i < s.normal.size(); ++i) {
    if (s.normal[i].mean == 0.0 && s.tangential[i].mean == 0.0) continue;
    const double removed = removed_by_cutter(bit, s, i);
    parts.push_back({bit.parts[i].name, figures_of(s.normal[i]), figures_of(s.tangential[i]),
                     quotient(s.part_energy[i], s.time), removed,
                     quotient(s.part_energy[i], removed)});
  }
  return parts;
}

}  // namespace

StepRates rates_of(const Move& move) {
  return {(move.X_WB1.p.z() - move.X_WB0.p.z()) / move.dt, move.turn / move.dt};
}

StepRates rates_of(const BitVelocity& velocity, const Pose& X_WB) {
  return {velocity.v_W.z(), velocity.w_W.dot(X_WB.R.col(2))};
}

void add(const LoadedStep& step, LoadStatistics& s) {
  add(s.wob, -step.loads.force_W.z());
  add(s.tob, -step.loads.torque_W.z());
  add(s.rop, step.rates.penetration);
  add(s.rotary_speed, step.rates.rotary);
  const Vec3 force_B = step.X_WB.R.transpose() * step.loads.force_W;
  s.lateral_B += (force_B - s.lateral_B) / static_cast<double>(s.wob.count);
  s.energy += step.loads.power * step.dt;
  s.time += step.dt;
  for (const double v : step.removed_by_part) s.removed += v;
  add_parts(step, s);
}

void add(const LoadedStep& step, Trace& t) {
  t.dt = step.dt;
  t.wob.push_back(-step.loads.force_W.z());
  t.tob.push_back(-step.loads.torque_W.z());
  t.rop.push_back(step.rates.penetration);
  t.rotary_speed.push_back(step.rates.rotary);
  t.centre_W.emplace_back(step.X_WB.p.head<2>());
}

std::optional<double> batch_uncertainty(const std::vector<double>& samples) {
  constexpr std::size_t batches = 8;
  constexpr double student_t = 2.364624;  // seven degrees of freedom, 97.5 %
  const std::size_t length = samples.size() / batches;
  if (length == 0) return std::nullopt;
  RunningVariance means;
  auto at = samples.end() - static_cast<std::ptrdiff_t>(batches * length);
  for (std::size_t k = 0; k < batches; ++k) {
    const auto next = at + static_cast<std::ptrdiff_t>(length);
    add(means, std::accumulate(at, next, 0.0) / static_cast<double>(length));
    at = next;
  }
  const double n = batches;
  return student_t * deviation(means) / std::sqrt(n - 1.0);  // deviation divides by n
}

SamplingUncertainty sampling_of(const Trace& t) {
  return {batch_uncertainty(t.wob), batch_uncertainty(t.tob), batch_uncertainty(t.rop),
          batch_uncertainty(t.rotary_speed)};
}

MeanAndDeviation figures_of(const RunningVariance& s) { return {s.mean, deviation(s)}; }

LoadStatisticsSummary figures_of(const bit::Bit& bit, const LoadStatistics& s, double end) {
  LoadStatisticsSummary f;
  f.steps = s.wob.count;
  f.from = end - s.time;
  f.to = end;
  f.wob = figures_of(s.wob);
  f.tob = figures_of(s.tob);
  f.rop = figures_of(s.rop);
  f.rotary_speed = figures_of(s.rotary_speed);
  const double R = bit.gage_radius, area = std::numbers::pi * R * R;
  f.aggressiveness = quotient(3.0 * f.tob.mean, 2.0 * R * f.wob.mean);
  f.specific_energy =
      f.wob.mean / area + quotient(f.rotary_speed.mean * f.tob.mean, area * f.rop.mean);
  f.imbalance = quotient(s.lateral_B.head<2>().norm(), f.wob.mean);
  f.imbalance_azimuth = std::atan2(s.lateral_B.y(), s.lateral_B.x());
  f.power = quotient(s.energy, s.time);
  f.parts = part_figures(bit, s);
  return f;
}

}  // namespace tdbd::simulation
