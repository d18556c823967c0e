#include "simulation/result/string_figures.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace tdbd::simulation {
namespace {

using Json = nlohmann::ordered_json;

Json frequencies(const std::vector<string::Mode>& modes) {
  Json all = Json::array();
  for (const string::Mode& m : modes) all.push_back(m.frequency);
  return all;
}

}  // namespace

double node_rest_share(const string::Chain& chain, long at_rest, long steps) {
  const double all = static_cast<double>(std::max(1L, steps)) * std::max(1, chain.count() - 1);
  return static_cast<double>(at_rest) / all;
}

Json statics_json(const StringFigures& f) {
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

Json steps_json(const StringFigures& f) {
  return {{"longest_step_s", f.longest_step},
          {"courant", {{"axial", f.courant.axial}, {"torsional", f.courant.torsional}}},
          {"node_rest_share", f.node_rest_share}};
}

}  // namespace tdbd::simulation
