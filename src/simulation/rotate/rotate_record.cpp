#include "simulation/rotate/rotate_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "rotation/screw.hpp"

namespace tdbd::simulation {
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
