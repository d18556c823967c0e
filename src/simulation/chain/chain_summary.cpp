#include <algorithm>
#include <nlohmann/json.hpp>

#include "simulation/chain/chain_run.hpp"
#include "simulation/result/figures.hpp"

namespace tdbd::simulation {
namespace {

using Json = nlohmann::ordered_json;

StringFigures figures_of(const ChainCase& c, const ChainSimulation& s) {
  const string::Elements& e = c.plan.chain.elements;
  return {e.length * c.plan.chain.count(),
          e.length,
          c.plan.chain.count(),
          static_loads(c.plan),
          chain_modes(c.plan),
          c.plan.longest_step,
          courant_numbers(c.plan.string.sections, e.length, c.time.step),
          node_rest_share(c.plan.chain, s.figures.node_steps_at_rest, s.steps_done)};
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

Json run_json(const ChainCase& c, const ChainSimulation& s, const StringFigures& figures) {
  const ChainFigures& f = s.figures;
  const double half = std::max(1.0, 0.5 * static_cast<double>(s.steps_done));
  const string::SurfaceLoad surface = string::surface_load(c.plan.chain, s.state.chain, s.work);
  const string::EndLoad bit = string::bit_load(c.plan.bit, s.state.bit, string::end_load(s.work));
  Json json{{"steps", s.steps_done}, {"step_s", c.time.step}, {"duration_s", s.time}};
  json.update(steps_json(figures));
  json.update(Json{{"second_half",
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
                   {"energy", energy_json(c, s)}});
  return json;
}

}  // namespace

std::string summary_json(const ChainCase& c, const ChainSimulation& s, RunStatus status) {
  Json json = summary_head("string", c.title, status, c.hash, 0);
  Json warnings = Json::array();
  for (const CaseWarning& w : c.warnings) warnings.push_back(without_place(w));
  const StringFigures figures = figures_of(c, s);
  json["warnings"] = warnings;
  json.update(statics_json(figures));
  if (c.time.steps > 0) json.update(run_json(c, s, figures));
  return json.dump(2) + "\n";
}

}  // namespace tdbd::simulation
