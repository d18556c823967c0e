#include "simulation/step/loads.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

namespace tdbd::simulation {

PartLoad load_of(const ForcePlan& plan, const bit::Bit& bit, const Pose& X_WB,
                 const BitVelocity& motion, double dt, const CutOfPart& c) {
  const Vec3 v_W = velocity_at(bit, X_WB, motion, c.cone, c.cut.point);
  const forces::PartCut cut = cut_at_velocity(v_W, dt, c);
  const forces::PartForce f = forces::force(law_of(plan, c), cut);
  return {f.force, f.point, f.normal, f.tangential, -f.force.dot(v_W)};
}

double torque_about_cone(const bit::Bit& bit, const Pose& X_WB, int cone, const PartLoad& load) {
  const Pose X_WK = X_WB * bit.cones[at(cone)].X_BK;
  return X_WK.R.col(2).dot((load.point_W - X_WK.p).cross(load.force_W));
}

void clear(const bit::Bit& bit, BitLoads& loads) {
  loads.parts.assign(bit.parts.size(), {});
  loads.cone_torques.assign(bit.cones.size(), 0.0);
  loads.force_W = loads.torque_W = Vec3::Zero();
  loads.power = 0.0;
}

void add(const PartLoad& p, const bit::Bit& bit, const Pose& X_WB, const CutOfPart& c,
         BitLoads& loads) {
  PartLoad& part = loads.parts[at(c.part)];
  const double share = p.force_W.norm(), total = part.force_W.norm() + share;
  if (total > 0.0) part.point_W += share / total * (p.point_W - part.point_W);
  part.force_W += p.force_W;
  part.normal += p.normal;
  part.tangential += p.tangential;
  part.power += p.power;
  loads.force_W += p.force_W;
  loads.torque_W += (p.point_W - X_WB.p).cross(p.force_W);
  loads.power += p.power;
  if (c.cone >= 0) loads.cone_torques[at(c.cone)] += torque_about_cone(bit, X_WB, c.cone, p);
}

void sum_loads(const ForcePlan& plan, const bit::Bit& bit, const Pose& X_WB,
               const BitVelocity& motion, double dt, const std::vector<CutOfPart>& cuts,
               BitLoads& loads) {
  clear(bit, loads);
  for (const CutOfPart& c : cuts) add(load_of(plan, bit, X_WB, motion, dt, c), bit, X_WB, c, loads);
}

namespace {

/// Slope of a law by differences of a millionth of the speed: well above rounding, and small
/// compared with the curvature.
Mat3 slope(const forces::Law& law, const CutOfPart& cut, const Vec3& v, double dt, const Vec3& F) {
  constexpr double over_speed = 1e-6;
  const double dv = over_speed * v.norm();
  Mat3 D;
  for (int j = 0; j < 3; ++j) {
    const forces::PartCut moved = cut_at_velocity(v + dv * Vec3::Unit(j), dt, cut);
    D.col(j) = (F - forces::force(law, moved).force) / dv;
  }
  return D;
}

}  // namespace

Mat3 secant_resistance(const Vec3& v, const Vec3& F) {
  const double v2 = v.squaredNorm(), along = F.dot(v) / v2;
  const Vec3 q = -(F - along * v) / v2;
  return -along * Mat3::Identity() + q * v.transpose() - v * q.transpose();
}

PartDrag drag_of(const ForcePlan& plan, const CutOfPart& cut, const Vec3& v_W, double dt,
                 Resistance which) {
  const Vec3 v = v_W.norm() > smallest_speed ? v_W : Vec3(smallest_speed * cut.cut.normal);
  const forces::Law& law = law_of(plan, cut);
  PartDrag drag;
  drag.force = forces::force(law, cut_at_velocity(v, dt, cut));
  if (which == Resistance::secant) drag.resistance = secant_resistance(v, drag.force.force);
  if (which == Resistance::tangent) drag.resistance = slope(law, cut, v, dt, drag.force.force);
  return drag;
}

namespace {

/// The augmented normal force and its slope with respect to v_n.
struct Normal {
  double p, slope;  // N, N s/m
};

Normal normal_force(const PressedContact& c, double into, double along) {
  const double compliance = c.law.ramp > 0.0 ? c.law.ramp * along / c.law.limit : 0.0;
  const double slope = c.k_n / (1.0 + c.k_n * compliance);
  const double p = (c.p + c.k_n * (into - c.free_speed)) / (1.0 + c.k_n * compliance);
  if (p <= 0.0) return {0.0, 0.0};
  return p < c.law.limit ? Normal{p, slope} : Normal{c.law.limit, 0.0};
}

/// d mu/d speed, s/m.
double friction_slope(const forces::Sliding& s, double speed) {
  return -s.mu * s.weakening / s.weakening_speed * std::exp(-speed / s.weakening_speed);
}

}  // namespace

PartDrag drag_of(const PressedContact& c, const Vec3& v_W) {
  const Vec3& n = c.normal_W;
  const double into = v_W.dot(n);
  const Vec3 slip = v_W - into * n;
  const double along = slip.norm();
  const double at_slip = c.slip.value_or(along);
  const Normal normal = normal_force(c, into, at_slip);
  const double mu = forces::friction_at(c.law.sliding, at_slip), most = mu * normal.p;
  Vec3 t = c.friction_W + c.k_t * slip;
  const double wanted = t.norm();
  const Mat3 across = Mat3::Identity() - n * n.transpose();
  PartDrag drag;
  drag.resistance = normal.slope * n * n.transpose();
  if (wanted <= most) {
    drag.resistance += c.k_t * across;
  } else {
    const Vec3 e = t / wanted;
    t = most * e;
    drag.resistance += most / wanted * c.k_t * (across - e * e.transpose()) +
                       mu * normal.slope * e * n.transpose();
    if (along > 0.0 && !c.slip)
      drag.resistance +=
          normal.p * friction_slope(c.law.sliding, along) / along * e * slip.transpose();
  }
  drag.force.normal = normal.p;
  drag.force.tangential = t.norm();
  drag.force.force = -normal.p * n - t;
  return drag;
}

void update_estimate(PressedContact& c, const Vec3& v_W) {
  const PartDrag now = drag_of(c, v_W);
  c.p = now.force.normal;
  c.friction_W = -now.force.force - c.p * c.normal_W;
}

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
  return {
      {"wob_mean_n", known(u.wob)},       {"tob_mean_n_m", known(u.tob)},
      {"rop_mean_m_per_s", known(u.rop)}, {"rotary_speed_mean_rad_per_s", known(u.rotary_speed)},
      {"imbalance", known(u.imbalance)},  {"of", "sampling"},
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
    parts.push_back({bit.parts[i].name, summarize(s.normal[i]), summarize(s.tangential[i]),
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
  t.force_B.emplace_back((step.X_WB.R.transpose() * step.loads.force_W).head<2>());
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

std::optional<double> imbalance_uncertainty(const Trace& t) {
  const double weight = std::accumulate(t.wob.begin(), t.wob.end(), 0.0);
  const Eigen::Vector2d across =
      std::accumulate(t.force_B.begin(), t.force_B.end(), Eigen::Vector2d(0.0, 0.0));
  if (t.force_B.size() != t.wob.size() || !(weight > 0.0) || !(across.norm() > 0.0))
    return std::nullopt;
  const double ratio = across.norm() / weight;
  std::vector<double> errors(t.wob.size());
  for (std::size_t i = 0; i < errors.size(); ++i)
    errors[i] = t.force_B[i].dot(across) / across.norm() - ratio * t.wob[i];
  const std::optional<double> half_width = batch_uncertainty(errors);
  if (!half_width) return std::nullopt;
  return *half_width * static_cast<double>(t.wob.size()) / weight;
}

SamplingUncertainty sampling_of(const Trace& t) {
  return {batch_uncertainty(t.wob), batch_uncertainty(t.tob), batch_uncertainty(t.rop),
          batch_uncertainty(t.rotary_speed), imbalance_uncertainty(t)};
}

MeanAndDeviation summarize(const RunningVariance& s) { return {s.mean, deviation(s)}; }

LoadStatisticsSummary summarize(const bit::Bit& bit, const LoadStatistics& s, double end) {
  LoadStatisticsSummary f;
  f.steps = s.wob.count;
  f.from = end - s.time;
  f.to = end;
  f.wob = summarize(s.wob);
  f.tob = summarize(s.tob);
  f.rop = summarize(s.rop);
  f.rotary_speed = summarize(s.rotary_speed);
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
