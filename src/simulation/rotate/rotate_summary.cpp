#include "simulation/rotate/rotate_summary.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "simulation/result/summary.hpp"

namespace tdbd::simulation {
namespace {

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

std::string summary_json(const RotateCase& c, const RotateSimulation& s, RunStatus status) {
  Json json = summary_head("rotate", c.title, status, c.hash, 0);
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
