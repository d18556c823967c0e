#include "simulation/rotate/rotate_simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/error.hpp"
#include "rotation/quaternion.hpp"
#include "rotation/screw.hpp"

namespace tdbd::simulation {
namespace {

using dynamics::RotationState;

void raise(double& largest, double value) { largest = std::max(largest, value); }

void watch(const RotateCase& c, const RotationState& s, Invariants& v) {
  const Vec3 change = s.momentum_W - v.momentum_W;
  raise(v.momentum_drift_squared, change.squaredNorm());
  raise(v.vertical_drift, std::abs(change.z()));
  for (std::size_t k = 0; k < v.cone_momenta.size(); ++k)
    raise(v.cone_momentum_drift, std::abs(s.cone_momenta[k] - v.cone_momenta[k]));
  raise(v.quaternion_defect, std::abs(s.q_WB.squaredNorm() - 1.0));
  raise(v.energy_drift, std::abs(total_energy(c, s) - v.energy));
  raise(v.largest_speed, dynamics::angular_velocity(c.body, s).norm());
}

bool conserves_energy(const dynamics::Loads& loads) {
  const auto acts = [](const dynamics::ConeLoad& cone) {
    return cone.internal != 0.0 || cone.external != 0.0 || cone.damping != 0.0;
  };
  return loads.body_torque_B.isZero(0.0) && loads.space_torque_W.isZero(0.0) &&
         loads.damping_W.isZero(0.0) && loads.harmonics.empty() && loads.samples.empty() &&
         std::ranges::none_of(loads.cones, acts);
}

bool is_finite(const RotationState& s) {
  double sum = s.momentum_W.sum() + s.q_WB.coeffs().sum();
  for (std::size_t k = 0; k < s.cone_angles.size(); ++k)
    sum += s.cone_angles[k] + s.cone_momenta[k];
  return std::isfinite(sum);
}

}  // namespace

std::vector<CaseWarning> end_warnings(const RotateCase& c, const RotateSimulation& s) {
  constexpr double largest_drift = 0.01;
  std::vector<CaseWarning> warnings;
  const Invariants& v = s.invariants;
  const std::string key = "time.step";
  const double drift = v.energy_drift / v.energy_scale;
  if (conserves_energy(c.loads) && drift > largest_drift)
    warnings.push_back(
        {c.place_of_step, key,
         fmt::format("the energy of this conservative motion has changed by {:.2g} % of "
                     "its scale; for meaningful results use a shorter step than "
                     "{:.3g} s, so that it changes by less than {:.2g} %",
                     100.0 * drift, c.time.step, 100.0 * largest_drift)});
  const double turn = v.largest_speed * c.time.step;
  const bool warned = std::ranges::count(c.warnings, key, &CaseWarning::key) > 0;
  if (turn > largest_turn_in_step && !warned)
    warnings.push_back(
        {c.place_of_step, key,
         fmt::format("the body has turned by up to {:.3g} rad in a step of {:.3g} s; "
                     "for meaningful results use at most {} rad: {:.2g} s",
                     turn, c.time.step, largest_turn_in_step,
                     largest_turn_in_step / v.largest_speed)});
  return warnings;
}

double total_energy(const RotateCase& c, const RotationState& s) {
  return dynamics::kinetic_energy(c.body, s) + dynamics::potential_energy(c.loads, s);
}

double twist(const RotationState& s) { return rotation::twist_angle(s.q_WB, s.turns); }

RotateSimulation start(const RotateCase& c) {
  RotateSimulation s;
  s.rotating = dynamics::start(c.body, c.loads, c.start);
  const RotationState& state = s.rotating.state;
  Invariants& v = s.invariants;
  v.momentum_W = state.momentum_W;
  v.cone_momenta = state.cone_momenta;
  v.energy = total_energy(c, state);
  v.energy_scale = dynamics::kinetic_energy(c.body, state) +
                   std::abs(dynamics::potential_energy(c.loads, state)) +
                   std::abs(c.loads.gravity_moment);
  if (v.energy_scale == 0.0) v.energy_scale = 1.0;
  if (!is_finite(state) || !std::isfinite(v.energy))
    throw InputError(c.path +
                     ": found a start whose energy is not finite, expected smaller numbers");
  watch(c, state, v);
  return s;
}

void advance(const RotateCase& c, RotateSimulation& s, long steps) {
  RotationState& state = s.rotating.state;
  for (long i = 0; i < steps; ++i) {
    dynamics::step(c.body, c.loads, c.integrator, c.time.step, s.rotating);
    ++s.steps_done;
    state.time = c.time.step * static_cast<double>(s.steps_done);  // a sum would round each step
    watch(c, state, s.invariants);
  }
  if (!is_finite(state))
    throw RunError("the state is no longer finite: the step is too long for these loads");
}

namespace {

enum Axis { none = -1, xyz, quaternion, cone };

/// The columns, in the order in which row_of fills them.
std::vector<RecordColumn> columns() {
  return {
      {"time", "s", "time"},
      {"quaternion", "1", "attitude of the bit, unit quaternion, bit to space", quaternion},
      {"rotation_vector", "rad", "attitude of the bit, rotation vector, bit to space", xyz},
      {"angular_velocity", "rad/s", "angular velocity of the bit, bit frame", xyz},
      {"body_momentum", "N m s", "angular momentum of bit and cones, bit frame", xyz},
      {"space_momentum", "N m s", "angular momentum of bit and cones, space frame", xyz},
      {"cone_angle", "rad", "angle of the cone about its axis, unwrapped", cone},
      {"cone_momentum", "N m s", "angular momentum of the cone about its axis", cone},
      {"cone_spin", "rad/s", "speed of the cone about its axis, seen from the bit", cone},
      {"kinetic_energy", "J", "kinetic energy of bit and cones"},
      {"potential_energy", "J", "potential energy of gravity and springs"},
      {"total_energy", "J", "kinetic and potential energy"},
      {"twist", "rad", "turn about the vertical, swing-twist, unwrapped"},
      {"axis_W", "1", "third axis of the bit in space, R e3: the axis of a top", xyz},
  };
}

RecordLayout layout_for(const RotateCase& c) {
  RecordLayout layout;
  layout.axes = {{"xyz", {"x", "y", "z"}}, {"quaternion_part", {"w", "x", "y", "z"}}, {"cone", {}}};
  for (std::size_t k = 0; k < c.body.cones.size(); ++k)
    layout.axes[cone].components.push_back(fmt::format("{}", k + 1));
  layout.columns = columns();
  layout.labels = {{"xyz", "component", xyz, layout.axes[xyz].components},
                   {"quaternion_part", "scalar and vector part", quaternion,
                    layout.axes[quaternion].components}};
  return layout;
}

void add(std::vector<double>& row, const Vec3& v) { row.insert(row.end(), {v.x(), v.y(), v.z()}); }

void row_of(const RotateCase& c, const dynamics::RotationState& s, std::vector<double>& row) {
  const Mat3 R_WB = s.q_WB.toRotationMatrix();
  const Vec3 w_B = dynamics::angular_velocity(c.body, s);
  const double kinetic = dynamics::kinetic_energy(c.body, s);
  const double potential = dynamics::potential_energy(c.loads, s);
  row = {s.time, s.q_WB.w(), s.q_WB.x(), s.q_WB.y(), s.q_WB.z()};
  add(row, rotation::log(R_WB));
  add(row, w_B);
  add(row, dynamics::body_momentum(s));
  add(row, s.momentum_W);
  row.insert(row.end(), s.cone_angles.begin(), s.cone_angles.end());
  row.insert(row.end(), s.cone_momenta.begin(), s.cone_momenta.end());
  for (std::size_t k = 0; k < c.body.cones.size(); ++k)
    row.push_back(dynamics::cone_rate(c.body.cones[k], s.cone_momenta[k], w_B));
  row.insert(row.end(), {kinetic, potential, kinetic + potential, twist(s)});
  add(row, R_WB.col(2));
}

using Json = nlohmann::ordered_json;

Json list(const Vec3& v) { return Json::array({v.x(), v.y(), v.z()}); }

Json rows(const Mat3& m) { return Json::array({list(m.row(0)), list(m.row(1)), list(m.row(2))}); }

Json cone_spins(const RotateCase& c, const dynamics::RotationState& s) {
  const Vec3 w_B = dynamics::angular_velocity(c.body, s);
  Json spins = Json::array();
  for (std::size_t k = 0; k < c.body.cones.size(); ++k)
    spins.push_back(dynamics::cone_rate(c.body.cones[k], s.cone_momenta[k], w_B));
  return spins;
}

Json integrator_json(const RotateCase& c) {
  return {{"drift", drift_name(c.integrator.drift)},
          {"drifts_per_step", c.integrator.drifts_per_step},
          {"order", c.integrator.order}};
}

Json state_json(const RotateCase& c, const RotateSimulation& s) {
  const dynamics::RotationState& state = s.rotating.state;
  return {{"attitude", rows(state.q_WB.toRotationMatrix())},
          {"body_momentum", list(dynamics::body_momentum(state))},
          {"space_momentum", list(state.momentum_W)},
          {"space_momentum_start", list(s.invariants.momentum_W)},
          {"angular_velocity", list(dynamics::angular_velocity(c.body, state))},
          {"cone_angles", state.cone_angles},
          {"cone_momenta", state.cone_momenta},
          {"cone_spins", cone_spins(c, state)},
          {"twist_rad", twist(state)}};
}

Json invariants_json(const Invariants& v, double energy_end) {
  return {{"energy_start", v.energy},
          {"energy_end", energy_end},
          {"energy_scale", v.energy_scale},
          {"energy_drift_max", v.energy_drift / v.energy_scale},
          {"energy_drift_end", (energy_end - v.energy) / v.energy_scale},
          {"momentum_drift_max", std::sqrt(v.momentum_drift_squared)},
          {"vertical_momentum_drift_max", v.vertical_drift},
          {"cone_momentum_drift_max", v.cone_momentum_drift},
          {"unit_quaternion_defect_max", v.quaternion_defect}};
}

}  // namespace

RotateHistory::RotateHistory(const std::filesystem::path& path, const RotateCase& c)
    : width_(layout_for(c).row_width()), record_(path, layout_for(c)) {}

bool RotateHistory::append(const RotateCase& c, const RotateSimulation& s) {
  if (s.steps_done == last_step_) return false;
  row_of(c, s.rotating.state, row_);
  record_.append(row_);
  last_step_ = s.steps_done;
  return true;
}

void write_rotate_checkpoint(const std::filesystem::path& path, const RotateCase& c,
                             const RotateSimulation& s, const RotateWritten& written) {
  tdbd::write_checkpoint(path, {c.hash, c.resolved}, s, written);
}

RotateCheckpoint read_rotate_checkpoint(const std::filesystem::path& path, const RotateCase& c) {
  RotateCheckpoint saved;
  tdbd::read_checkpoint(path, {c.hash, c.resolved}, saved.simulation, saved.written);
  return saved;
}

void RotateRecorder::restore(const RotateWritten& written) {
  keeper_.begin_rows(history_.width(), written.rows);
  if (RowLog* rows = keeper_.rows())
    rows->replay([&](std::span<const double> row) { history_.append_again(row); });
  history_.set_last_step(written.last_step);
}

void RotateRecorder::begin() {
  if (history_.append(c_, s_)) keeper_.append(history_.last_row());
}

void RotateRecorder::record() {
  if (s_.steps_done % c_.history_every == 0 || s_.steps_done == c_.time.steps) begin();
  if (keeper_.is_due(s_.steps_done)) keep_checkpoint();
}

void RotateRecorder::keep_checkpoint() {
  const RowLog* rows = keeper_.rows();
  if (rows == nullptr) return;
  const RotateWritten written{rows->rows(), history_.last_step()};
  keeper_.keep(
      [&](const std::filesystem::path& file) { write_rotate_checkpoint(file, c_, s_, written); });
}

/// Appends the row of the interruption after the checkpoint, so that the resumed run does not
/// contain it.
void RotateRecorder::close(RunStatus status) {
  if (status == RunStatus::interrupted) {
    keep_checkpoint();
    history_.append(c_, s_);
  }
  history_.close();
}

void RotateRecorder::keep_so_far(const std::exception&) {
  ignore_failure([&] { history_.append(c_, s_); });
  ignore_failure([&] { history_.close(); });
}

std::vector<std::string> answer_lines(const RotateCase& c, const RotateSimulation& s) {
  constexpr double degree = std::numbers::pi / 180.0, rpm = 2.0 * std::numbers::pi / 60.0;
  const dynamics::RotationState& state = s.rotating.state;
  const double speed = dynamics::angular_velocity(c.body, state).norm();
  const double tilt = std::acos(std::clamp(state.q_WB.toRotationMatrix()(2, 2), -1.0, 1.0));
  const double turns = twist(state) / (2.0 * std::numbers::pi);
  const Invariants& v = s.invariants;
  return {fmt::format("turned           {} about the vertical",
                      counted(fmt::format("{:.4g}", turns), "revolution")),
          fmt::format("speed at the end {:.4g} rad/s, {:.4g} rpm", speed, speed / rpm),
          fmt::format("axis at the end  {:.4g} deg from the vertical", tilt / degree),
          fmt::format("energy           {:.6g} J at the start, {:.6g} J at the end", v.energy,
                      total_energy(c, state)),
          fmt::format("momentum         {:.6g} N m s at the start, {:.6g} N m s at the end",
                      v.momentum_W.norm(), state.momentum_W.norm())};
}

std::string summary_json(const RotateCase& c, const RotateSimulation& s, RunStatus status) {
  Json json = summary_head("rotate", c.title, status, c.hash, 0);
  for (const std::string& w : texts_of_result(c.warnings)) json["warnings"].push_back(w);
  for (const CaseWarning& w : end_warnings(c, s)) json["warnings"].push_back(without_place(w));
  json.update(Json{{"steps", s.steps_done},
                   {"step_s", c.time.step},
                   {"duration_s", s.rotating.state.time},
                   {"integrator", integrator_json(c)},
                   {"torque_evaluations", s.rotating.evaluations}});
  json.update(state_json(c, s));
  json.update(invariants_json(s.invariants, total_energy(c, s.rotating.state)));
  return json.dump(2) + "\n";
}

}  // namespace tdbd::simulation
