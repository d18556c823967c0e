#include "reference/literature/drag/spokes/spoke_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tdbd::reference {
namespace {

/// Azimuth of the tip in spokes.
double tip_spoke(const SpokeCutter& cutter, const BitPlace& place, int spokes) {
  const Vec3 tip_W = turned(place, cutter.tip_B) + place.p_WB;
  return std::atan2(tip_W.y(), tip_W.x()) / (2.0 * std::numbers::pi) * spokes;
}

void add_crossings(SpokeTracker& tracker, std::size_t cutter, double to) {
  const double from = tracker.at[cutter];
  const auto add = [&](double k) {
    tracker.crossings.push_back(
        {(k - from) / (to - from), cutter, spoke_number(k, tracker.spokes), to > from});
  };
  for (double k = std::floor(from) + 1.0; k <= to; k += 1.0) add(k);
  for (double k = std::ceil(from) - 1.0; k >= to; k -= 1.0) add(k);
}

}  // namespace

int spoke_number(double unwrapped, int spokes) {
  return static_cast<int>(unwrapped - spokes * std::floor(unwrapped / spokes)) % spokes;
}

int spoke_ahead(const PlacedCutter& c, const Vec3& v_W, int spokes) {
  const double at = std::atan2(c.sine, c.cosine) / (2.0 * std::numbers::pi) * spokes;
  const bool rising = c.cosine * v_W.y() - c.sine * v_W.x() >= 0.0;
  return spoke_number(rising ? std::ceil(at) : std::floor(at), spokes);
}

SpokeTracker spoke_tracker(const std::vector<SpokeCutter>& cutters, const BitPlace& start,
                           int spokes) {
  SpokeTracker tracker{spokes, {}, {}};
  for (const SpokeCutter& c : cutters) tracker.at.push_back(tip_spoke(c, start, spokes));
  return tracker;
}

void track(SpokeTracker& tracker, const std::vector<SpokeCutter>& cutters, const BitPlace& end) {
  tracker.crossings.clear();
  for (std::size_t i = 0; i < cutters.size(); ++i) {
    const double seen = tip_spoke(cutters[i], end, tracker.spokes), from = tracker.at[i],
                 to = from + std::remainder(seen - from, tracker.spokes);
    add_crossings(tracker, i, to);
    tracker.at[i] = to;
  }
  std::ranges::stable_sort(tracker.crossings, {}, &SpokeCrossing::share);
}

}  // namespace tdbd::reference
