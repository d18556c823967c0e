#include <algorithm>
#include <nlohmann/json.hpp>

#include "simulation/chain/chain_modes.hpp"
#include "simulation/chain/chain_run.hpp"

namespace tdbd::simulation {
namespace {

using Json = nlohmann::ordered_json;

Json frequencies(const std::vector<string::Mode>& modes) {
  Json all = Json::array();
  for (const string::Mode& m : modes) all.push_back(m.frequency);
  return all;
}

Json statics_json(const ChainPlan& p) {
  Json all = Json::object();
  for (const StaticLoad& l : static_loads(p))
    all[l.name] = {{"hook_load_n", l.load.surface.hook_load},
                   {"surface_torque_n_m", l.load.surface.torque}};
  return all;
}

/// Fastest waves in units of an element per step.
Json courant_json(const ChainCase& c) {
  double axial = 0.0, torsional = 0.0;
  for (const string::Section& s : c.plan.string.sections) {
    if (s.mass > 0.0) axial = std::max(axial, string::axial_wave_speed(s));
    if (s.inertia > 0.0) torsional = std::max(torsional, string::torsional_wave_speed(s));
  }
  const double per_step = c.time.step / c.plan.chain.elements.length;
  return {{"axial", axial * per_step}, {"torsional", torsional * per_step}};
}

Json energy_json(const ChainCase& c, const ChainSimulation& s) {
  const string::ChainLedger& l = s.state.chain.ledger;
  const string::BitLedger& b = s.state.bit.ledger;
  const double stored =
      string::stored_energy(c.plan.chain, s.state.chain, string::motion_of(s.state.bit)) +
      string::stored_energy(c.plan.bit, s.state.bit);
  return {{"stored_j", stored},
          {"top_j", l.top},
          {"gravity_j", l.gravity + b.gravity},
          {"string_friction_j", l.friction},
          {"string_damping_j", l.damping},
          {"string_loss_j", l.loss + b.loss},
          {"top_damping_j", l.top_damping},
          {"bit_cut_j", b.cut},
          {"bit_friction_j", b.friction},
          {"bit_damping_j", b.damping},
          {"residual_max_j", s.figures.residual}};
}

Json run_json(const ChainCase& c, const ChainSimulation& s) {
  const ChainFigures& f = s.figures;
  const double half = std::max(1.0, 0.5 * static_cast<double>(s.steps_done));
  const double node_steps =
      static_cast<double>(std::max(1L, s.steps_done)) * std::max(1, c.plan.chain.count() - 1);
  const string::SurfaceLoad surface = string::surface_load(c.plan.chain, s.state.chain, s.work);
  const string::EndLoad bit = string::bit_load(c.plan.bit, s.state.bit, string::end_load(s.work));
  return {{"steps", s.steps_done},
          {"step_s", c.time.step},
          {"duration_s", s.time},
          {"longest_step_s", c.plan.longest_step},
          {"courant", courant_json(c)},
          {"node_rest_share", static_cast<double>(f.node_steps_at_rest) / node_steps},
          {"second_half",
           {{"bit_speed_min_rad_s", f.least_speed},
            {"bit_speed_max_rad_s", f.largest_speed},
            {"bit_rest_share", static_cast<double>(f.bit_steps_at_rest) / half}}},
          {"end",
           {{"hook_load_n", surface.hook_load},
            {"surface_torque_n_m", surface.torque},
            {"weight_on_bit_n", bit.pull},
            {"torque_on_bit_n_m", bit.torque},
            {"bit_rate_m_s", s.state.bit.velocity},
            {"bit_speed_rad_s", s.state.bit.rotary_speed}}},
          {"energy", energy_json(c, s)}};
}

}  // namespace

std::string summary_json(const ChainCase& c, const ChainSimulation& s, RunStatus status) {
  Json json = summary_head("string", c.title, status, c.hash, 0);
  Json warnings = Json::array();
  for (const CaseWarning& w : c.warnings) warnings.push_back(without_place(w));
  const ChainModes modes = chain_modes(c.plan);
  json.update(Json{{"warnings", warnings},
                   {"length_m", c.plan.chain.elements.length * c.plan.chain.count()},
                   {"elements", c.plan.chain.count()},
                   {"element_length_m", c.plan.chain.elements.length},
                   {"static", statics_json(c.plan)},
                   {"axial_frequencies_hz", frequencies(modes.axial)},
                   {"torsional_frequencies_hz", frequencies(modes.torsional)}});
  if (c.time.steps > 0) json.update(run_json(c, s));
  return json.dump(2) + "\n";
}

}  // namespace tdbd::simulation
