#include "sweep/point/planar.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "bit/profile/bit_analysis.hpp"
#include "bit/profile/counted_cutters.hpp"
#include "bit/profile/engagement.hpp"
#include "core/error.hpp"

namespace tdbd::sweep {

nlohmann::ordered_json planar_summary(const simulation::Case& c, double normal_ratio) {
  const simulation::Motion& m = c.motion;
  if (bit::counted_cutters(c.bit).empty())
    throw InputError(
        "bit.file: found a bit without cutters that cut from the start, expected one that the "
        "planar model knows");
  if (!(m.rotary_speed > 0.0 && m.rate_of_penetration > 0.0))
    throw InputError(
        "motion: found no advance per revolution, expected a rotary speed and a rate of "
        "penetration");
  const double advance = 2.0 * std::numbers::pi * m.rate_of_penetration / m.rotary_speed;
  const std::vector<bit::Cutter> cutters = bit::cutters_at(c.bit, bit::counted_cutters(c.bit));
  const bit::Engagement e = bit::engagement(cutters, advance, bit::report_column_width);
  return {{"advance_m", advance},
          {"imbalance", bit::planar_imbalance(cutters, e.area, normal_ratio)},
          {"imbalance_of_unit_law", bit::imbalance(cutters, e.area)},
          {"mean_redundancy", bit::mean_redundancy(e.cutting)},
          {"cut_area_m2", std::accumulate(e.area.begin(), e.area.end(), 0.0)},
          {"largest_cut_area_m2", std::ranges::max(e.area)},
          {"engaged_cutters", std::ranges::count_if(e.area, [](double a) { return a > 0.0; })}};
}

}  // namespace tdbd::sweep
