#include "simulation/result/wear_figures.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bit/mass_properties.hpp"

namespace tdbd::simulation {
namespace {

using WearJson = nlohmann::ordered_json;

WearJson piece_json(const PieceWearFigures& p) {
  const double height = std::max(0.0, p.flat.height);
  WearJson j{{"name", p.name}};
  j[p.is_cutter ? "flat_height_m" : "lost_height_m"] = height;
  if (p.is_cutter) j["flat_width_m"] = p.flat.width;
  j["flat_area_m2"] = p.flat.area;
  j["worn_volume_m3"] = p.flat.volume;
  j["pending_volume_m3"] = p.pending;
  j["temperature_k"] = p.rub.temperature;
  j["normal_force_n"] = p.rub.force;
  return j;
}

WearJson records_json(const WearFigures& f) {
  WearJson distance = WearJson::array(), by_cutter = WearJson::object(),
           by_part = WearJson::object();
  WearJson weight = WearJson::array(), torque = WearJson::array(), rate = WearJson::array();
  for (const WearRecord& r : f.records) {
    distance.push_back(r.distance);
    weight.push_back(r.weight);
    torque.push_back(r.torque);
    rate.push_back(r.rate);
  }
  for (std::size_t i = 0; i < f.pieces.size(); ++i) {
    const bool is_cutter = f.pieces[i].is_cutter;
    WearJson& p = (is_cutter ? by_cutter : by_part)[f.pieces[i].name];
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
  WearJson j{{"distance_m", distance},
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

/// Sums over the pieces.
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

WearJson wear_json(const WearFigures& f) {
  WearJson cutters = WearJson::array(), parts = WearJson::array();
  for (const PieceWearFigures& p : f.pieces)
    (p.is_cutter ? cutters : parts).push_back(piece_json(p));
  WearJson j{{"acceleration", f.acceleration},
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
