#include "simulation/step/force_figures.hpp"

#include <nlohmann/json.hpp>

namespace tdbd::simulation {
namespace {

using Json = nlohmann::ordered_json;

Json part_json(const PartLoadFigures& p) {
  return {{"name", p.name},
          {"normal_mean_n", p.normal.mean},
          {"normal_std_n", p.normal.deviation},
          {"tangential_mean_n", p.tangential.mean},
          {"tangential_std_n", p.tangential.deviation},
          {"power_mean_w", p.power},
          {"removed_volume_m3", p.removed},
          {"specific_energy_pa", p.specific_energy}};
}

}  // namespace

Json to_json(const LoadFigures& f) {
  Json parts = Json::array();
  for (const PartLoadFigures& p : f.parts) parts.push_back(part_json(p));
  return {{"means_from_s", f.from},
          {"means_to_s", f.to},
          {"wob_mean_n", f.wob.mean},
          {"wob_std_n", f.wob.deviation},
          {"tob_mean_n_m", f.tob.mean},
          {"tob_std_n_m", f.tob.deviation},
          {"rop_mean_m_per_s", f.rop.mean},
          {"rop_std_m_per_s", f.rop.deviation},
          {"rotary_speed_mean_rad_per_s", f.rotary_speed.mean},
          {"rotary_speed_std_rad_per_s", f.rotary_speed.deviation},
          {"aggressiveness", f.aggressiveness},
          {"mechanical_specific_energy_pa", f.specific_energy},
          {"imbalance", f.imbalance},
          {"imbalance_azimuth_rad", f.imbalance_azimuth},
          {"drilling_power_mean_w", f.power},
          {"forces", parts}};
}

}  // namespace tdbd::simulation
