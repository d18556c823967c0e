#include "simulation/chain/chain_history.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "core/whole_file.hpp"
#include "simulation/chain/chain_modes.hpp"

namespace tdbd::simulation {
namespace {

double node_depth(const ChainCase& c, int node) { return node * c.plan.chain.elements.length; }

/// A motion of a node, the bit's for the last.
struct NodeMotion {
  double displacement, velocity, angle, rotary_speed;
};
NodeMotion motion_at(const ChainSimulation& s, int node) {
  const string::ChainState& x = s.state.chain;
  const std::size_t i = at(node);
  if (i < x.velocity.size())
    return {x.displacement[i], x.velocity[i], x.angle[i], x.rotary_speed[i]};
  const string::BitState& b = s.state.bit;
  return {b.displacement, b.velocity, b.angle, b.rotary_speed};
}

RecordLayout history_layout(const ChainCase& c) {
  RecordLayout l;
  l.axes = {{"node", {}}};
  for (const int node : c.nodes)
    l.axes[0].components.push_back(fmt::format("{:.6g}m", node_depth(c, node)));
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
               {"energy_residual", "J", "change of stored and lost less put in"},
               {"node_tension", "N", "effective tension above the node", 0},
               {"node_torque", "N m", "torque above the node", 0},
               {"node_rate", "m/s", "speed of the node along the hole", 0},
               {"node_speed", "rad/s", "rotary speed of the node", 0},
               {"node_side_force", "N", "with which the node presses on the hole", 0}};
  return l;
}

RecordLayout profile_layout(const ChainCase& c) {
  RecordLayout l;
  l.axes = {{"node", {}}, {"element", {}}};
  for (int i = 0; i <= c.plan.chain.count(); ++i)
    l.axes[0].components.push_back(fmt::format("{}", node_depth(c, i)));
  for (int e = 0; e < c.plan.chain.count(); ++e)
    l.axes[1].components.push_back(
        fmt::format("{}", node_depth(c, e) + 0.5 * c.plan.chain.elements.length));
  l.labels = {
      {"node_depth", "measured depth of the node, m", 0, l.axes[0].components},
      {"element_depth", "measured depth of the element's middle, m", 1, l.axes[1].components}};
  l.columns = {{"time", "s", "time"},
               {"displacement", "m", "along the hole", 0},
               {"velocity", "m/s", "along the hole", 0},
               {"angle", "rad", "turn about the hole", 0},
               {"rotary_speed", "rad/s", "about the hole", 0},
               {"side_force", "N", "with which the node presses on the hole", 0},
               {"tension", "N", "effective tension", 1},
               {"torque", "N m", "torque handed down", 1}};
  l.storage = Storage::deflated;
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
    : folder_(folder), record_(folder / "history.nc", history_layout(c)) {
  if (c.profile_every > 0)
    profiles_ =
        std::make_unique<RecordNetcdf>(partial_path(folder / "string.nc"), profile_layout(c));
}

void ChainHistory::append(const ChainCase& c, const ChainSimulation& s) {
  if (s.steps_done != last_row_ &&
      (s.steps_done % c.history_every == 0 || s.steps_done == c.time.steps))
    append_row(c, s);
  if (profiles_ && s.steps_done != last_profile_ && s.steps_done % c.profile_every == 0)
    append_profile(c, s);
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
  const auto above = [](int node) { return at(node > 0 ? node - 1 : 0); };
  for (const int node : c.nodes) row_.push_back(s.work.tension[above(node)]);
  for (const int node : c.nodes) row_.push_back(s.work.torque[above(node)]);
  for (const int node : c.nodes) row_.push_back(motion_at(s, node).velocity);
  for (const int node : c.nodes) row_.push_back(motion_at(s, node).rotary_speed);
  for (const int node : c.nodes) row_.push_back(s.work.side_force[at(node)]);
  record_.append(row_);
  last_row_ = s.steps_done;
}

void ChainHistory::append_profile(const ChainCase& c, const ChainSimulation& s) {
  const int n = c.plan.chain.count();
  row_ = {s.time};
  for (int i = 0; i <= n; ++i) row_.push_back(motion_at(s, i).displacement);
  for (int i = 0; i <= n; ++i) row_.push_back(motion_at(s, i).velocity);
  for (int i = 0; i <= n; ++i) row_.push_back(motion_at(s, i).angle);
  for (int i = 0; i <= n; ++i) row_.push_back(motion_at(s, i).rotary_speed);
  row_.insert(row_.end(), s.work.side_force.begin(), s.work.side_force.end());
  row_.insert(row_.end(), s.work.tension.begin(), s.work.tension.end());
  row_.insert(row_.end(), s.work.torque.begin(), s.work.torque.end());
  profiles_->append(row_);
  last_profile_ = s.steps_done;
}

void ChainHistory::close() {
  record_.close();
  if (!profiles_) return;
  profiles_->close();
  rename_partial(folder_ / "string.nc");
}

void write_static_tables(const std::filesystem::path& folder, const ChainCase& c) {
  write_static(folder / "static.csv", c);
  write_broomstick(folder / "broomstick.csv", c);
  write_modes(folder / "modes.csv", c);
}

}  // namespace tdbd::simulation
