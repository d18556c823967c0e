#include "simulation/result/drive_figures.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "simulation/case/chain_statics.hpp"

namespace tdbd::simulation {
namespace {

using Json = nlohmann::ordered_json;

constexpr double full_turn = 2.0 * std::numbers::pi;  // rad

double frequency(double stiffness, double inertia) {
  return stiffness > 0.0 ? std::sqrt(stiffness / inertia) / full_turn : 0.0;
}

}  // namespace

Expected expected_of(const dynamics::DrillingSystem& s, double rotary_speed) {
  Expected e;
  const double inertia = s.gyrostat.inertia_B(2, 2);
  if (s.chained) {
    const ChainModes modes = chain_modes(s.chained->chain, s.mass, inertia);
    e.torsional = modes.torsional.front().frequency;
    e.axial = modes.axial.front().frequency;
  } else {
    e.torsional = frequency(s.string.turn_stiffness(2, 2), inertia);
    e.axial = frequency(s.spring(2, 2), s.mass);
  }
  e.lateral = frequency(s.string.stiffness(0, 0), s.mass);
  e.rolling_speed = rotary_speed * s.wall.ring_radius;
  if (s.wall.stiffness > 0.0 && s.wall.clearance > 0.0)
    e.rolling = rotary_speed * s.wall.ring_radius / s.wall.clearance / full_turn;
  return e;
}

DriveRow drive_row(const dynamics::DrillingSystem& system, const dynamics::Drilling& d,
                   const dynamics::DrillingWork& work, double turned) {
  const dynamics::StoredEnergy stored = dynamics::stored_energy(system, work.at, d.state);
  const dynamics::EnergyLedger& l = d.ledger;
  DriveRow row;
  row.rock_z = d.state.rock_z;
  row.string_twist = (system.chained ? d.chain.angle.front() : work.at.top.angle) - turned;
  row.stored = dynamics::total(stored);
  row.top = l.top;
  row.cutting = -l.cut_bit;
  row.lost = dynamics::lost(l);
  row.residual = dynamics::residual(stored, l);
  if (!system.chained) return row;
  const string::SurfaceLoad surface =
      string::surface_load(system.chained->chain, d.chain, work.chain);
  row.hook_load = surface.hook_load;
  row.surface_torque = surface.torque;
  row.top_speed = d.chain.rotary_speed.front();
  row.block_speed = d.chain.velocity.front();
  return row;
}

Json energy_json(const DriveFigures& f) {
  const dynamics::EnergyLedger& l = f.ledger;
  const double residual = dynamics::residual(f.stored, l);
  return {{"start_j", l.start},
          {"top_j", l.top},
          {"gravity_j", l.gravity},
          {"cutting_j", -l.cut_bit},
          {"cutting_to_rock_motion_j", l.cut_rock},
          {"damped_string_j", l.damped_string},
          {"damped_bearings_j", l.damped_bearings},
          {"damped_rock_j", l.damped_rock},
          {"wall_loss_j", l.wall_loss},
          {"wall_friction_j", l.wall_friction},
          {"chain_gravity_j", l.chain_gravity},
          {"chain_friction_j", l.chain_friction},
          {"chain_damping_j", l.chain_damping},
          {"chain_loss_j", l.chain_loss},
          {"top_damping_j", l.top_damping},
          {"chain_j", f.stored.chain},
          {"kinetic_j", f.stored.translation + f.stored.rotation + f.stored.cones + f.stored.rock},
          {"elastic_j", f.stored.string + f.stored.wall + f.stored.rock_mount},
          {"residual_j", residual},
          {"residual_over_top", l.top != 0.0 ? residual / l.top : 0.0},
          {"cutting_by_part_j", f.cutting_by_part}};
}

Json energy_order_json(const EnergyOrder& o) {
  return {{"reason", o.residual.reason},
          {"levels", o.residual.steps.size()},
          {"from_s", o.from},
          {"window_s", o.window},
          {"steps_s", o.residual.steps},
          {"residuals_j", o.residual.residuals}};
}

Json standing_json(const StandingStatistics& s) {
  return {{"steps", s.steps}, {"unsettled", s.unsettled}, {"most_rounds", s.most_rounds}};
}

Json diagnosis_json(const Diagnosis& d, const Expected& e) {
  return {{"text", d.text},
          {"stick_slip_severity", d.stick_slip_severity},
          {"stuck_share", d.stuck_share},
          {"torsional_frequency_hz", d.torsional_frequency},
          {"torsional_frequency_expected_hz", e.torsional},
          {"lost_contact_share", d.lost_contact_share},
          {"wob_swing", d.wob_swing},
          {"axial_frequency_hz", d.axial_frequency},
          {"axial_frequency_expected_hz", e.axial},
          {"lateral_frequency_expected_hz", e.lateral},
          {"orbit_radius_m", d.orbit_radius},
          {"orbit_frequency_hz", d.orbit_frequency},
          {"rolling_frequency_expected_hz", -e.rolling},
          {"rolling_frequency_at_orbit_hz",
           d.orbit_radius > 0.0 ? -e.rolling_speed / (full_turn * d.orbit_radius) : 0.0},
          {"whirl", whirl_name(d.whirl)}};
}

}  // namespace tdbd::simulation
