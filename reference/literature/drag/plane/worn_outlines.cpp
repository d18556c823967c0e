#include "reference/literature/drag/plane/worn_outlines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

constexpr double no_bottom = -std::numeric_limits<double>::infinity();
constexpr double upright_cosine = 1e-12;  // cosine of a profile angle that counts as 90 degrees

/// Both branches of a cutter's ellipse, with r and z as functions of one angle.
struct CutterEllipse {
  double middle_r = 0.0, middle_z = 0.0, reach = 0.0;  // m; reach: in r
  double phase = 0.0, along = 0.0, across = 0.0;

  explicit CutterEllipse(const bit::Cutter& c) {
    const double a = c.diameter / 2.0, b = a * std::cos(c.back_rake);
    const double sine = std::sin(c.profile_angle), cosine = std::cos(c.profile_angle);
    middle_r = c.tip_radius - b * sine;
    middle_z = -c.tip_height - b * cosine;
    reach = std::hypot(b * sine, a * cosine);
    phase = std::atan2(a * cosine, b * sine);
    along = b * cosine;
    across = a * sine;
  }
  double z(double s) const { return middle_z + along * std::cos(s) - across * std::sin(s); }
};

/// Finds the columns whose middles the ellipse covers.
void place_worn_columns(WornOutlines& o, WornOutlines::Place& p, const CutterEllipse& e) {
  const double first = std::ceil(std::max(0.0, e.middle_r - e.reach) / o.column - 0.5);
  const double last = std::floor((e.middle_r + e.reach) / o.column - 0.5);
  p.first_column = static_cast<std::size_t>(std::max(0.0, first));
  p.columns = last < first ? 0 : static_cast<std::size_t>(last) - p.first_column + 1;
  p.begin = o.lower.size();
  for (std::size_t k = 0; k < p.columns; ++k) {
    const double r = (static_cast<double>(p.first_column + k) + 0.5) * o.column;
    const double half = std::acos(std::clamp((r - e.middle_r) / e.reach, -1.0, 1.0));
    const double a = e.z(e.phase - half), b = e.z(e.phase + half);
    o.lower.push_back(std::max(a, b));
    o.upper.push_back(std::min(a, b));
  }
  o.most_columns = std::max(o.most_columns, p.first_column + p.columns);
}

WornOutlines::Place worn_place(const bit::Cutter& c) {
  const double turns = c.azimuth / (2.0 * std::numbers::pi);
  return {.tip_radius = c.tip_radius,
          .tip_depth = -c.tip_height,
          .sine = std::sin(c.profile_angle),
          .cosine = std::cos(c.profile_angle),
          .turn = turns - std::floor(turns)};
}

/// Depth of the worn outline's lower branch in a column; `no_bottom` if the flat removed all of it.
double worn_depth(const WornOutlines::Place& p, double r, double lower, double upper, double worn) {
  const double left = -worn - (r - p.tip_radius) * p.sine;  // limit of (z - tip) cos below the flat
  if (std::abs(p.cosine) < upright_cosine) return left >= 0.0 ? lower : no_bottom;
  const double flat = p.tip_depth + left / p.cosine;
  if (p.cosine < 0.0) return lower >= flat ? lower : no_bottom;
  return flat >= upper ? std::min(lower, flat) : no_bottom;
}

/// One pass of a cutter; stores what it removes.
void worn_pass(const WornOutlines& o, std::size_t cutter, double worn, double deeper,
               WornCut& cut) {
  const WornOutlines::Place& p = o.places[cutter];
  double area = 0.0, moment = 0.0;
  for (std::size_t k = 0; k < p.columns; ++k) {
    const double r = (static_cast<double>(p.first_column + k) + 0.5) * o.column;
    double& bottom = cut.bottom[p.first_column + k];
    const double lower = o.lower[p.begin + k], upper = o.upper[p.begin + k];
    const double z = (worn > 0.0 ? worn_depth(p, r, lower, upper, worn) : lower) + deeper;
    if (z <= bottom) continue;
    area += z - bottom;
    moment += r * (z - bottom);
    bottom = z;
  }
  cut.area[cutter] = area * o.column;
  cut.volume[cutter] = 2.0 * std::numbers::pi * moment * o.column;
}

}  // namespace

WornOutlines worn_outlines(const std::vector<bit::Cutter>& cutters, double column) {
  if (cutters.empty()) throw InputError("Glowka: found no cutters, expected at least one");
  if (!(column > 0.0)) throw InputError("Glowka: found no width of columns, expected one above 0");
  WornOutlines o;
  o.column = column;
  for (const bit::Cutter& c : cutters) {
    if (!(c.diameter > 0.0))
      throw InputError("Glowka: found cutter " + std::to_string(c.id) +
                       " without a diameter, expected one above 0");
    o.places.push_back(worn_place(c));
    place_worn_columns(o, o.places.back(), CutterEllipse(c));
  }
  o.order.resize(cutters.size());
  std::iota(o.order.begin(), o.order.end(), 0);
  std::stable_sort(o.order.begin(), o.order.end(), [&](std::size_t i, std::size_t j) {
    return o.places[i].turn > o.places[j].turn;
  });
  return o;
}

void cut_worn(const WornOutlines& outlines, const std::vector<double>& worn, double advance,
              WornCut& cut) {
  cut.area.resize(outlines.places.size());
  cut.volume.resize(outlines.places.size());
  cut.bottom.assign(outlines.most_columns, no_bottom);
  for (int revolution = 0; revolution < 2; ++revolution)
    for (const std::size_t i : outlines.order)
      worn_pass(outlines, i, worn[i], advance * (revolution + 1 - outlines.places[i].turn), cut);
}

}  // namespace tdbd::reference
