#include "simulation/step/wear.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tdbd::simulation {

double volume_after(const WearState& s, const CutterWear& c, double window, double time) {
  const double ratio = s.previous_time > 0.0 ? time / s.previous_time : 0.0;
  const double worn = window + 0.5 * ratio * (window - ratio * c.previous);
  return c.volume + std::max(0.0, worn);
}

void take_wear_step(const std::vector<bit::WearSolid>& solids, WearState& s,
                    std::vector<bit::WearFlat>& flats) {
  std::vector<double> volumes;
  std::vector<bit::WearFlat> next;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const CutterWear& c = s.cutters[i];
    volumes.push_back(volume_after(s, c, c.window, s.window_time));
    const auto flat = bit::flat_of_volume(solids[i], volumes.back(), c.height);
    if (!flat)
      throw WearEnd(
          fmt::format("the flat of cutter-{} is as large as the cutter: {:.4g} mm3 are worn off it",
                      solids[i].id, 1e9 * volumes.back()));
    next.push_back(*flat);
  }
  for (std::size_t i = 0; i < solids.size(); ++i) {
    CutterWear& c = s.cutters[i];
    c.volume = volumes[i];
    c.height = next[i].height;
    c.previous = std::exchange(c.window, 0.0);
  }
  flats = std::move(next);
  s.previous_time = std::exchange(s.window_time, 0.0);
  s.window_steps = 0;
  s.window_distance = 0.0;
  ++s.steps;
}

double wear_ledger_defect(const std::vector<bit::WearSolid>& solids, const WearState& s) {
  double defect = 0.0;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const CutterWear& c = s.cutters[i];
    if (c.volume > 0.0)
      defect = std::max(defect,
                        std::abs(bit::flat_at(solids[i], c.height).volume - c.volume) / c.volume);
  }
  return defect;
}

void add(WearRecord record, WearRecords& to) {
  constexpr std::size_t most = 64;
  if (to.seen++ % to.every != 0) return;
  to.records.push_back(std::move(record));
  if (to.records.size() <= most) return;
  for (std::size_t i = 2; i < to.records.size(); i += 2)
    to.records[i / 2] = std::move(to.records[i]);
  to.records.resize((to.records.size() + 1) / 2);
  to.every *= 2;
}

}  // namespace tdbd::simulation
