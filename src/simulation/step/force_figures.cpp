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

/// Keys are those of the means.
Json uncertainty_json(const SamplingUncertainty& u) {
  const auto known = [](const std::optional<double>& x) { return x ? Json(*x) : Json(); };
  return {{"wob_mean_n", known(u.wob)},
          {"tob_mean_n_m", known(u.tob)},
          {"rop_mean_m_per_s", known(u.rop)},
          {"rotary_speed_mean_rad_per_s", known(u.rotary_speed)},
          {"of", "sampling"},
          {"coverage", sampling_coverage}};
}

Json to_json(const LoadFigures& f) {
  Json parts = Json::array();
  for (const PartLoadFigures& p : f.parts) parts.push_back(part_json(p));
  const auto known = [&f](double x) { return f.steps > 0 ? Json(x) : Json(); };
  return {{"means_from_s", known(f.from)},
          {"means_to_s", known(f.to)},
          {"wob_mean_n", known(f.wob.mean)},
          {"wob_std_n", known(f.wob.deviation)},
          {"tob_mean_n_m", known(f.tob.mean)},
          {"tob_std_n_m", known(f.tob.deviation)},
          {"rop_mean_m_per_s", known(f.rop.mean)},
          {"rop_std_m_per_s", known(f.rop.deviation)},
          {"rotary_speed_mean_rad_per_s", known(f.rotary_speed.mean)},
          {"rotary_speed_std_rad_per_s", known(f.rotary_speed.deviation)},
          {"uncertainty", uncertainty_json(f.uncertainty)},
          {"aggressiveness", known(f.aggressiveness)},
          {"mechanical_specific_energy_pa", known(f.specific_energy)},
          {"imbalance", known(f.imbalance)},
          {"imbalance_azimuth_rad", known(f.imbalance_azimuth)},
          {"drilling_power_mean_w", known(f.power)},
          {"forces", parts}};
}

}  // namespace tdbd::simulation
