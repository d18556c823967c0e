#include "simulation/result/figures.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "bit/bit.hpp"

namespace tdbd::simulation {
namespace {

using Json = nlohmann::ordered_json;

constexpr double full_turn = 2.0 * std::numbers::pi;  // rad

double frequency(double stiffness, double inertia) {
  return stiffness > 0.0 ? std::sqrt(stiffness / inertia) / full_turn : 0.0;
}

Json frequencies(const std::vector<string::Mode>& modes) {
  Json all = Json::array();
  for (const string::Mode& m : modes) all.push_back(m.frequency);
  return all;
}

Json piece_json(const PieceWearFigures& p) {
  const double height = std::max(0.0, p.flat.height);
  Json j{{"name", p.name}};
  j[p.is_cutter ? "flat_height_m" : "lost_height_m"] = height;
  if (p.is_cutter) j["flat_width_m"] = p.flat.width;
  j["flat_area_m2"] = p.flat.area;
  j["worn_volume_m3"] = p.flat.volume;
  j["pending_volume_m3"] = p.pending;
  j["temperature_k"] = p.rub.temperature;
  j["normal_force_n"] = p.rub.force;
  return j;
}

Json records_json(const WearFigures& f) {
  Json distance = Json::array(), by_cutter = Json::object(), by_part = Json::object();
  Json weight = Json::array(), torque = Json::array(), rate = Json::array();
  for (const WearRecord& r : f.records) {
    distance.push_back(r.distance);
    weight.push_back(r.weight);
    torque.push_back(r.torque);
    rate.push_back(r.rate);
  }
  for (std::size_t i = 0; i < f.pieces.size(); ++i) {
    const bool is_cutter = f.pieces[i].is_cutter;
    Json& p = (is_cutter ? by_cutter : by_part)[f.pieces[i].name];
    for (const WearRecord& r : f.records) {
      if (is_cutter)
        p["flat_width_m"].push_back(r.width[i]);
      else
        p["lost_height_m"].push_back(r.height[i]);
      p["worn_volume_m3"].push_back(r.volume[i]);
      p["temperature_k"].push_back(r.temperature[i]);
      p["normal_force_n"].push_back(r.force[i]);
    }
  }
  Json j{{"distance_m", distance},
         {"weight_on_bit_n", weight},
         {"torque_on_bit_n_m", torque},
         {"rate_of_penetration_m_per_s", rate},
         {"cutters", by_cutter}};
  if (!by_part.empty()) j["parts"] = by_part;
  return j;
}

double pending_volume(const PieceWear& c, const bit::WearFlat& flat) {
  return c.window.volume + flat.area * c.window.height;
}

/// Computes the sums over the pieces.
void sum_worn(WearFigures& f) {
  double squares = 0.0, count = 0.0;
  for (const PieceWearFigures& c : f.pieces) {
    f.worn += c.flat.volume;
    f.largest = std::max(f.largest, c.flat.volume);
    squares += c.flat.volume * c.flat.volume;
    count += c.flat.volume > 0.0 ? 1.0 : 0.0;
  }
  if (!(count > 0.0)) return;
  const double mean = f.worn / count;
  f.unevenness = std::sqrt(std::max(0.0, squares / count - mean * mean)) / mean;
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

Json implicit_forces_json(const ImplicitStatistics& s) {
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

double node_rest_share(const string::Chain& chain, long at_rest, long steps) {
  const double all = static_cast<double>(std::max(1L, steps)) * std::max(1, chain.count() - 1);
  return static_cast<double>(at_rest) / all;
}

Json statics_json(const StringSummary& f) {
  Json loads = Json::object();
  for (const StaticLoad& l : f.statics)
    loads[l.name] = {{"hook_load_n", l.load.surface.hook_load},
                     {"surface_torque_n_m", l.load.surface.torque}};
  return {{"length_m", f.length},
          {"elements", f.elements},
          {"element_length_m", f.element_length},
          {"static", loads},
          {"axial_frequencies_hz", frequencies(f.modes.axial)},
          {"torsional_frequencies_hz", frequencies(f.modes.torsional)}};
}

Json steps_json(const StringSummary& f) {
  return {{"longest_step_s", f.longest_step},
          {"courant", {{"axial", f.courant.axial}, {"torsional", f.courant.torsional}}},
          {"node_rest_share", f.node_rest_share}};
}

WearFigures figures_of_wear(const Case& c, const Simulation& s) {
  const WearState& state = *s.state.wear;
  const WearWork& w = *s.work.wear;
  WearFigures f;
  f.acceleration = c.wear.acceleration;
  f.distance = state.distance;
  f.steps = state.steps;
  f.ledger_defect = wear_ledger_defect(c.bit, w.worn.bit, w.solids, state);
  f.mass_lost = bit::mass_properties(c.bit).mass - bit::mass_properties(w.worn.bit).mass;
  std::vector<double> heights;
  for (std::size_t i = 0; i < state.pieces.size(); ++i) {
    heights.push_back(state.pieces[i].height);
    f.pieces.push_back({w.solids[i].name, w.solids[i].cutter >= 0, w.flats[i],
                        pending_volume(state.pieces[i], w.flats[i]), state.rubs[i]});
  }
  f.grade = bit::dull_grade(c.bit, w.solids, heights);
  sum_worn(f);
  f.records = s.statistics.wear.records;
  return f;
}

Json wear_json(const WearFigures& f) {
  Json cutters = Json::array(), parts = Json::array();
  for (const PieceWearFigures& p : f.pieces)
    (p.is_cutter ? cutters : parts).push_back(piece_json(p));
  Json j{{"acceleration", f.acceleration},
         {"distance_m", f.distance},
         {"wear_steps", f.steps},
         {"volume_ledger_defect", f.ledger_defect},
         {"mass_lost_kg", f.mass_lost},
         {"worn_volume_m3", f.worn},
         {"largest_worn_volume_m3", f.largest},
         {"worn_volume_unevenness", f.unevenness},
         {"dull_grade_inner", f.grade.inner},
         {"dull_grade_outer", f.grade.outer},
         {"cutters", cutters}};
  if (!parts.empty()) j["parts"] = parts;
  j["over_distance"] = records_json(f);
  return j;
}

}  // namespace tdbd::simulation
