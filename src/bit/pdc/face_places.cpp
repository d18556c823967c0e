#include "bit/pdc/face_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tdbd::bit {
namespace {

/// A stretch of the profile on which the spacing varies linearly.
struct Stretch {
  double start, length;  ///< m
  double spacing;        ///< m, at the start
  double slope;          ///< of the spacing

  /// Integral of 1 / spacing over the first x metres.
  double count(double x) const {
    return slope == 0.0 ? x / spacing : std::log1p(slope * x / spacing) / slope;
  }
  /// Its inverse.
  double place(double n) const {
    return start + (slope == 0.0 ? n * spacing : spacing * std::expm1(slope * n) / slope);
  }
};

Stretch stretch(const PdcDesign& d, Region region, double start, double end,
                double overlap_at_end) {
  const double diameter = choice_in(d.diameter, region), length = std::max(0.0, end - start);
  const double first = diameter * (1.0 - law_at(d.overlap, d.profile, start));
  const double last = diameter * (1.0 - overlap_at_end);
  return {start, length, first, length > 0.0 ? (last - first) / length : 0.0};
}

}  // namespace

std::vector<double> face_places(const PdcDesign& d) {
  const auto [cone, nose, shoulder, gage] = region_ends(d.profile);
  const double first = d.first_radius / std::cos(d.profile.cone_angle);
  const std::array<Stretch, 3> stretches{
      stretch(d, Region::cone, first, cone, d.overlap.nose),
      stretch(d, Region::nose, cone, nose, d.overlap.shoulder),
      stretch(d, Region::shoulder, nose, shoulder, d.overlap.gage)};
  double total = 0.0;
  for (const Stretch& part : stretches) total += part.count(part.length);
  const int gaps = std::max(1, static_cast<int>(std::ceil(total)));
  std::vector<double> places;
  for (int k = 0; k < gaps; ++k) {
    double n = total * k / gaps;
    std::size_t i = 0;
    for (; i + 1 < stretches.size() && n > stretches[i].count(stretches[i].length); ++i)
      n -= stretches[i].count(stretches[i].length);
    places.push_back(stretches[i].place(n));
  }
  places.push_back(shoulder);
  return places;
}

}  // namespace tdbd::bit
