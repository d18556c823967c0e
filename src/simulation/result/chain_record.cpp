#include "simulation/result/chain_record.hpp"

#include <fmt/format.h>

#include "core/types.hpp"

namespace tdbd::simulation {
namespace {

double node_depth(const string::Chain& c, int node) { return node * c.elements.length; }

/// Returns the motion of a node. That of the last node is the motion of the bit.
string::EndMotion motion_at(const ChainView& c, int node) {
  const string::ChainState& x = c.state;
  const std::size_t i = at(node);
  if (i < x.velocity.size())
    return {x.displacement[i], x.angle[i], x.velocity[i], x.rotary_speed[i]};
  return c.end;
}

RecordLayout profile_layout(const string::Chain& c) {
  RecordLayout l;
  l.axes = {{"node", {}}, {"element", {}}};
  for (int i = 0; i <= c.count(); ++i)
    l.axes[0].components.push_back(fmt::format("{}", node_depth(c, i)));
  for (int e = 0; e < c.count(); ++e)
    l.axes[1].components.push_back(fmt::format("{}", node_depth(c, e) + 0.5 * c.elements.length));
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

}  // namespace

std::vector<std::string> node_names(const string::Chain& chain, const std::vector<int>& nodes) {
  std::vector<std::string> names;
  names.reserve(nodes.size());
  for (const int node : nodes) names.push_back(fmt::format("{:.6g}m", node_depth(chain, node)));
  return names;
}

void add_node_columns(const std::vector<std::string>& names, Over over, RecordLayout& l) {
  const int axis = static_cast<int>(l.axes.size());
  l.axes.push_back({"node", names});
  const auto add = [&](const char* name, const char* units, const char* long_name) {
    l.columns.push_back({name, units, long_name, axis, InCsv::yes, over});
  };
  add("node_tension", "N", "effective tension above the node");
  add("node_torque", "N m", "torque above the node");
  add("node_rate", "m/s", "speed of the node along the hole");
  add("node_speed", "rad/s", "rotary speed of the node");
  add("node_side_force", "N", "with which the node presses on the hole");
}

void append_nodes(const ChainView& c, const std::vector<int>& nodes, std::vector<double>& row) {
  const auto above = [](int node) { return at(node > 0 ? node - 1 : 0); };
  for (const int node : nodes) row.push_back(c.work.tension[above(node)]);
  for (const int node : nodes) row.push_back(c.work.torque[above(node)]);
  for (const int node : nodes) row.push_back(motion_at(c, node).velocity);
  for (const int node : nodes) row.push_back(motion_at(c, node).rotary_speed);
  for (const int node : nodes) row.push_back(c.work.side_force[at(node)]);
}

ChainProfiles::ChainProfiles(const std::filesystem::path& path, const string::Chain& chain)
    : layout_(profile_layout(chain)), record_(path, layout_, CsvBeside::no) {}

void ChainProfiles::append(double time, const ChainView& c) {
  const int n = c.chain.count();
  row_ = {time};
  for (int i = 0; i <= n; ++i) row_.push_back(motion_at(c, i).displacement);
  for (int i = 0; i <= n; ++i) row_.push_back(motion_at(c, i).velocity);
  for (int i = 0; i <= n; ++i) row_.push_back(motion_at(c, i).angle);
  for (int i = 0; i <= n; ++i) row_.push_back(motion_at(c, i).rotary_speed);
  row_.insert(row_.end(), c.work.side_force.begin(), c.work.side_force.end());
  row_.insert(row_.end(), c.work.tension.begin(), c.work.tension.end());
  row_.insert(row_.end(), c.work.torque.begin(), c.work.torque.end());
  record_.append(row_);
}

}  // namespace tdbd::simulation
