#include "simulation/chain/chain_history.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "io/whole_file.hpp"

namespace tdbd::simulation {
namespace {

double node_depth(const ChainCase& c, int node) { return node * c.plan.chain.elements.length; }

ChainView view_of(const ChainCase& c, const ChainSimulation& s) {
  return {c.plan.chain, s.state.chain, s.work, string::motion_of(s.state.bit)};
}

RecordLayout history_layout(const ChainCase& c) {
  RecordLayout l;
  l.columns = {{"time", "s", "time"},
               {"hook_load", "N", "hook load"},
               {"surface_weight", "N", "tare of the hook load less the hook load"},
               {"surface_torque", "N m", "torque of the top drive on the string"},
               {"top_speed", "rad/s", "rotary speed of the top"},
               {"block_speed", "m/s", "rate at which the top is lowered"},
               {"weight", "N", "weight on bit"},
               {"torque", "N m", "torque on bit"},
               {"speed", "rad/s", "rotary speed of the bit"},
               {"rate", "m/s", "speed of the bit along the hole"},
               {"displacement", "m", "of the bit along the hole"},
               {"twist", "rad", "turn of the top ahead of the bit"},
               {"depth_of_cut", "m", "per blade"},
               {"resting_nodes", "1", "nodes at rest"},
               {"energy_residual", "J", "change of stored and lost less put in"}};
  add_node_columns(node_names(c.plan.chain, c.output.nodes), Over::point, l);
  return l;
}

void write_static(const std::filesystem::path& file, const ChainCase& c) {
  const std::vector<StaticLoad> loads = static_loads(c.plan);
  std::string text = "depth_m,vertical_depth_m,north_m,east_m,inclination_deg";
  for (const StaticLoad& l : loads) text += fmt::format(",{0}_tension_n,{0}_torque_n_m", l.name);
  text += "\n";
  for (int e = 0; e < c.plan.chain.count(); ++e) {
    const double depth = node_depth(c, e) + 0.5 * c.plan.chain.elements.length;
    const Vec3 place = string::position_at(c.plan.string.survey, depth);
    const Vec3 t = string::tangent_at(c.plan.string.survey, depth);
    text += fmt::format("{},{},{},{},{}", depth, place.z(), place.x(), place.y(),
                        std::atan2(t.head<2>().norm(), t.z()) * 180.0 / std::numbers::pi);
    for (const StaticLoad& l : loads)
      text += fmt::format(",{},{}", l.load.tension[at(e)], l.load.torque[at(e)]);
    text += "\n";
  }
  write_text(file, text);
}

void write_broomstick(const std::filesystem::path& file, const ChainCase& c) {
  std::string text = "bit_depth_m,pull_up_n,slack_off_n,rotate_n,rotate_torque_n_m\n";
  for (const DepthLoad& l : loads_by_depth(c.plan))
    text += fmt::format("{},{},{},{},{}\n", l.depth, l.pull_up, l.slack_off, l.rotate, l.torque);
  write_text(file, text);
}

void write_modes(const std::filesystem::path& file, const ChainCase& c) {
  const ChainModes modes = chain_modes(c.plan);
  std::string text = "depth_m";
  for (std::size_t k = 0; k < modes.axial.size(); ++k) text += fmt::format(",axial_{}", k + 1);
  for (std::size_t k = 0; k < modes.torsional.size(); ++k)
    text += fmt::format(",torsional_{}", k + 1);
  text += "\n";
  for (int i = 0; i <= c.plan.chain.count(); ++i) {
    text += fmt::format("{}", node_depth(c, i));
    for (const auto* all : {&modes.axial, &modes.torsional})
      for (const string::Mode& m : *all) text += fmt::format(",{}", m.shape[at(i)]);
    text += "\n";
  }
  write_text(file, text);
}

}  // namespace

ChainHistory::ChainHistory(const std::filesystem::path& folder, const ChainCase& c)
    : record_(folder / "history.nc", history_layout(c)) {
  if (c.output.profile_every > 0)
    profiles_ = std::make_unique<ChainProfiles>(folder / "string.nc", c.plan.chain);
}

void ChainHistory::append(const ChainCase& c, const ChainSimulation& s) {
  if (s.steps_done != last_row_ &&
      (s.steps_done % c.history_every == 0 || s.steps_done == c.time.steps))
    append_row(c, s);
  if (!profiles_ || s.steps_done == last_profile_ || s.steps_done % c.output.profile_every != 0)
    return;
  profiles_->append(s.time, view_of(c, s));
  last_profile_ = s.steps_done;
}

void ChainHistory::append_row(const ChainCase& c, const ChainSimulation& s) {
  const ChainPlan& p = c.plan;
  const string::SurfaceLoad surface = string::surface_load(p.chain, s.state.chain, s.work);
  const string::EndLoad bit = string::bit_load(p.bit, s.state.bit, string::end_load(s.work));
  const string::BitState& b = s.state.bit;
  const string::ChainState& x = s.state.chain;
  row_ = {s.time,
          surface.hook_load,
          p.chain.top.tare - surface.hook_load,
          surface.torque,
          x.rotary_speed[0],
          x.velocity[0],
          bit.pull,
          bit.torque,
          b.rotary_speed,
          b.velocity,
          b.displacement,
          x.angle[0] - b.angle,
          b.depth,
          static_cast<double>(s.work.resting),
          string::energy_balance(p.chain, p.bit, s.state) - s.figures.start_balance};
  append_nodes(view_of(c, s), c.output.nodes, row_);
  record_.append(row_);
  last_row_ = s.steps_done;
}

void ChainHistory::close() {
  record_.close();
  if (profiles_) profiles_->close();
}

void write_static_tables(const std::filesystem::path& folder, const ChainCase& c) {
  write_static(folder / "static.csv", c);
  write_broomstick(folder / "broomstick.csv", c);
  write_modes(folder / "modes.csv", c);
}

}  // namespace tdbd::simulation
