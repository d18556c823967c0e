#include "rock/section/engaged_ends.hpp"

#include <algorithm>

namespace tdbd::rock {
namespace {

void raise(std::optional<double>& end, double z) { end = end ? std::max(*end, z) : z; }

/// The engaged interval of a column's lower edge, m from its start along y.
struct EngagedStretch {
  double from, to;
};

EngagedStretch engaged_stretch(const FaceColumn& c, double length, double middle) {
  const double half = 0.5 * length / c.lower_length, width = c.y1 - c.y0;
  return {std::clamp(middle - half, 0.0, width), std::clamp(middle + half, 0.0, width)};
}

}  // namespace

EngagedEnds engaged_ends(const FaceColumns& face, const ColumnSums& sums) {
  EngagedEnds ends;
  for (std::size_t i = 0; i < face.columns.size(); ++i) {
    const FaceColumn& c = face.columns[i];
    if (sums.engaged[i] <= 0 || !(c.lower_length > 0.0)) continue;
    const double length = static_cast<double>(sums.engaged[i]) / sums.per_length;
    const double middle =
        static_cast<double>(sums.engaged_moment[i]) / sums.per_length_moment / length;
    const EngagedStretch s = engaged_stretch(c, length, middle);
    const double left = c.lower + s.from * c.lower_slope, right = c.lower + s.to * c.lower_slope;
    if (c.lower_slope <= 0.0) raise(ends[0], left);
    if (c.lower_slope >= 0.0) raise(ends[1], right);
  }
  return ends;
}

}  // namespace tdbd::rock
