#include "simulation/step/wear.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace tdbd::simulation {

namespace {

std::string worn_out(const bit::WearSolid& s) {
  if (s.cutter >= 0) return fmt::format("the flat of {} is as large as the cutter", s.name);
  return fmt::format("{} has lost {:.3g} mm of its {:.3g} mm", s.name, 1e3 * s.largest,
                     1e3 * s.size);
}

double extrapolated(double window, double previous, double ratio) {
  return std::max(0.0, window + 0.5 * ratio * (window - ratio * previous));
}

}  // namespace

WearAmount worn_after(const WearState& s, const PieceWear& c, const WearAmount& window,
                      double time) {
  const double ratio = s.previous_time > 0.0 ? time / s.previous_time : 0.0;
  return {extrapolated(window.volume, c.previous.volume, ratio),
          extrapolated(window.height, c.previous.height, ratio)};
}

std::optional<bit::WearFlat> flat_after(const bit::WearSolid& solid, const PieceWear& c,
                                        const WearAmount& worn) {
  double volume = c.volume + worn.volume;
  if (worn.height > 0.0) {
    const auto half = bit::flat_of_volume(solid, c.volume + 0.5 * worn.volume, c.height);
    if (!half || half->height + worn.height >= solid.largest) return std::nullopt;
    volume = bit::flat_at(solid, half->height + worn.height).volume + 0.5 * worn.volume;
  }
  return bit::flat_of_volume(solid, volume, c.height);
}

void take_wear_step(const std::vector<bit::WearSolid>& solids, WearState& s,
                    std::vector<bit::WearFlat>& flats) {
  std::vector<bit::WearFlat> next;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const PieceWear& c = s.pieces[i];
    const auto flat = flat_after(solids[i], c, worn_after(s, c, c.window, s.window_time));
    if (!flat)
      throw WearEnd(
          fmt::format("{}; it had lost {:.4g} mm3 before", worn_out(solids[i]), 1e9 * c.volume));
    next.push_back(*flat);
  }
  for (std::size_t i = 0; i < solids.size(); ++i) {
    PieceWear& c = s.pieces[i];
    c.volume = next[i].volume;
    c.height = next[i].height;
    c.previous = std::exchange(c.window, {});
  }
  flats = std::move(next);
  s.previous_time = std::exchange(s.window_time, 0.0);
  s.window_steps = 0;
  s.window_distance = s.window_weight = s.window_torque = 0.0;
  ++s.steps;
}

double wear_ledger_defect(const bit::Bit& fresh, const bit::Bit& worn,
                          const std::vector<bit::WearSolid>& solids, const WearState& s) {
  double beyond = 0.0, worn_volume = 0.0, by_meshes = 0.0;
  for (std::size_t i = 0; i < s.pieces.size(); ++i) {
    const double volume = s.pieces[i].volume;
    if (!(volume > 0.0)) continue;
    const bit::LostVolume lost = bit::lost_volume(fresh, worn, solids[i], s.pieces[i].height);
    beyond += std::abs(lost.beyond_flat - volume);
    worn_volume += volume;
    by_meshes = std::max(by_meshes, std::abs(lost.by_meshes - volume) / lost.whole);
  }
  return std::max(worn_volume > 0.0 ? beyond / worn_volume : 0.0, by_meshes);
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
