#include "simulation/result/wear_figures.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bit/mass_properties.hpp"

namespace tdbd::simulation {
namespace {

using WearJson = nlohmann::ordered_json;

WearJson cutter_json(const CutterWearFigures& c) {
  return {{"name", c.name},
          {"flat_height_m", std::max(0.0, c.flat.height)},
          {"flat_width_m", c.flat.width},
          {"flat_area_m2", c.flat.area},
          {"worn_volume_m3", c.flat.volume},
          {"pending_volume_m3", c.pending},
          {"temperature_k", c.rub.temperature},
          {"normal_force_n", c.rub.force}};
}

WearJson records_json(const WearFigures& f) {
  WearJson distance = WearJson::array(), by_cutter = WearJson::object();
  WearJson weight = WearJson::array(), torque = WearJson::array(), rate = WearJson::array();
  for (const WearRecord& r : f.records) {
    distance.push_back(r.distance);
    weight.push_back(r.weight);
    torque.push_back(r.torque);
    rate.push_back(r.rate);
  }
  for (std::size_t i = 0; i < f.cutters.size(); ++i) {
    WearJson& c = by_cutter[f.cutters[i].name];
    for (const WearRecord& r : f.records) {
      c["flat_width_m"].push_back(r.width[i]);
      c["worn_volume_m3"].push_back(r.volume[i]);
      c["temperature_k"].push_back(r.temperature[i]);
      c["normal_force_n"].push_back(r.force[i]);
    }
  }
  return {{"distance_m", distance},
          {"weight_on_bit_n", weight},
          {"torque_on_bit_n_m", torque},
          {"rate_of_penetration_m_per_s", rate},
          {"cutters", by_cutter}};
}

double pending_volume(const CutterWear& c, const bit::WearFlat& flat) {
  return c.window.volume + flat.area * c.window.height;
}

/// Sums over the cutters.
void sum_worn(WearFigures& f) {
  double squares = 0.0, count = 0.0;
  for (const CutterWearFigures& c : f.cutters) {
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

WearFigures figures_of_wear(const Case& c, const Simulation& s) {
  const WearState& state = *s.state.wear;
  const WearWork& w = *s.work.wear;
  WearFigures f;
  f.acceleration = c.wear.acceleration;
  f.distance = state.distance;
  f.steps = state.steps;
  f.ledger_defect = wear_ledger_defect(c.bit, w.worn.bit, state);
  f.mass_lost = bit::mass_properties(c.bit).mass - bit::mass_properties(w.worn.bit).mass;
  f.grade = bit::dull_grade(w.worn.bit);
  for (std::size_t i = 0; i < state.cutters.size(); ++i)
    f.cutters.push_back({cutter_name(c.bit.cutters[i]), w.flats[i],
                         pending_volume(state.cutters[i], w.flats[i]), state.rubs[i]});
  sum_worn(f);
  f.records = s.statistics.wear.records;
  return f;
}

WearJson wear_json(const WearFigures& f) {
  WearJson cutters = WearJson::array();
  for (const CutterWearFigures& c : f.cutters) cutters.push_back(cutter_json(c));
  return {{"acceleration", f.acceleration},
          {"distance_m", f.distance},
          {"wear_steps", f.steps},
          {"volume_ledger_defect", f.ledger_defect},
          {"mass_lost_kg", f.mass_lost},
          {"worn_volume_m3", f.worn},
          {"largest_worn_volume_m3", f.largest},
          {"worn_volume_unevenness", f.unevenness},
          {"dull_grade_inner", f.grade.inner},
          {"dull_grade_outer", f.grade.outer},
          {"cutters", cutters},
          {"over_distance", records_json(f)}};
}

}  // namespace tdbd::simulation
