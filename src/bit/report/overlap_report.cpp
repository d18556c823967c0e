#include "bit/report/overlap_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bit/body/enclosed_parts.hpp"

namespace tdbd::bit {
namespace {

double total(const std::vector<CutterOverlap>& overlaps) {
  double volume = 0.0;
  for (const CutterOverlap& o : overlaps) volume += o.volume;
  return volume;
}

int id_of(const Bit& bit, int cutter) { return bit.cutters[static_cast<std::size_t>(cutter)].id; }

}  // namespace

nlohmann::ordered_json overlaps_json(const Bit& bit, const std::vector<CutterOverlap>& overlaps) {
  nlohmann::ordered_json pairs = nlohmann::ordered_json::array();
  for (const CutterOverlap& o : overlaps)
    pairs.push_back({{"a", fmt::format("cutter-{}", id_of(bit, o.a))},
                     {"b", fmt::format("cutter-{}", id_of(bit, o.b))},
                     {"volume_m3", o.volume}});
  return {{"volume_m3", total(overlaps)}, {"pairs", pairs}};
}

std::string overlaps_text(const Bit& bit, const std::vector<CutterOverlap>& overlaps) {
  if (overlaps.empty()) return "";
  const CutterOverlap& worst = std::ranges::max(overlaps, {}, &CutterOverlap::volume);
  return fmt::format(
      "warning: {} pairs of cutters overlap by {:.1f} mm3 in all, which counts twice in the mass; "
      "most, {:.1f} mm3, cutters {} and {}\n",
      overlaps.size(), 1e9 * total(overlaps), 1e9 * worst.volume, id_of(bit, worst.a),
      id_of(bit, worst.b));
}

std::string enclosed_text(const Bit& bit) {
  std::string text;
  for (const auto& [inner, outer] : enclosed_parts(bit))
    text += fmt::format("warning: {} lies inside {}, so its volume counts twice in the mass\n",
                        bit.parts[static_cast<std::size_t>(inner)].name,
                        bit.parts[static_cast<std::size_t>(outer)].name);
  return text;
}

}  // namespace tdbd::bit
