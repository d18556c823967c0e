#include "reference/bit/radial_plane_engagement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr int revolutions = 5;
constexpr double never = -std::numeric_limits<double>::infinity();

/// A point as the fixed half-plane sees it.
struct Passing {
  double r, phi, depth;  ///< radius, m; azimuth, rad; z - advance phi / (2 pi), m
};

/// The deepest passing of one cutter at one column's radius.
struct Deepest {
  double phi = 0.0;
  double depth = never;
};

/// One cutter's pass through the half-plane in one revolution.
struct Pass {
  double theta;  ///< how far the bit has turned, rad
  double depth;  ///< m
  std::size_t cutter;
  int revolution;
};

using Columns = std::vector<std::vector<Deepest>>;  ///< [column][cutter]

bool takes_part(const bit::Part& part) {
  return part.cutter >= 0 && part.cutting == bit::Cutting::cuts;
}

double largest_radius(const bit::Bit& bit) {
  double reach = 0.0;
  for (const bit::Part& part : bit.parts)
    if (takes_part(part))
      for (const Vec3& x_P : part.mesh_P.positions)
        reach = std::max(reach, (part.X_BP * x_P).head<2>().norm());
  return reach;
}

/// Azimuth unwrapped to within half a turn of the cutter's own, which is taken in [0, 2 pi).
Passing passing(const Vec3& x_B, double cutter_azimuth, double advance) {
  const double own = cutter_azimuth - turn * std::floor(cutter_azimuth / turn);
  const double phi = own + std::remainder(std::atan2(x_B[1], x_B[0]) - own, turn);
  return {x_B.head<2>().norm(), phi, x_B[2] - advance * phi / turn};
}

/// Offer the straight piece between two passings to all columns whose centre it covers.
void offer(const Passing& a, const Passing& b, double width, std::size_t cutter, Columns& columns) {
  const auto [near, far] = std::minmax(a.r, b.r);
  const auto first = static_cast<std::size_t>(std::ceil(std::max(0.0, near / width - 0.5)));
  for (std::size_t i = first; i < columns.size(); ++i) {
    const double centre = (static_cast<double>(i) + 0.5) * width;
    if (centre > far) break;
    const double s = near < far ? (centre - a.r) / (b.r - a.r) : 0.0;
    const double depth = a.depth + s * (b.depth - a.depth);
    Deepest& deepest = columns[i][cutter];
    if (depth > deepest.depth) deepest = {a.phi + s * (b.phi - a.phi), depth};
  }
}

/// Offer one mesh edge from a_B to b_B, in pieces no longer than half a column.
void offer_edge(const Vec3& a_B, const Vec3& b_B, double azimuth, double advance, double width,
                std::size_t cutter, Columns& columns) {
  const int pieces = 1 + static_cast<int>((b_B - a_B).norm() / (0.5 * width));
  Passing last = passing(a_B, azimuth, advance);
  for (int k = 1; k <= pieces; ++k) {
    const double s = static_cast<double>(k) / pieces;
    const Passing next = passing((1.0 - s) * a_B + s * b_B, azimuth, advance);
    offer(last, next, width, cutter, columns);
    last = next;
  }
}

void offer_part(const bit::Bit& bit, const bit::Part& part, double advance, double width,
                Columns& columns) {
  const auto cutter = static_cast<std::size_t>(part.cutter);
  const double azimuth = bit.cutters[cutter].azimuth;
  for (const mesh::Triangle& f : part.mesh_P.triangles)
    for (int i = 0; i < 3; ++i)
      offer_edge(part.X_BP * part.mesh_P.positions[f[i]],
                 part.X_BP * part.mesh_P.positions[f[(i + 1) % 3]], azimuth, advance, width, cutter,
                 columns);
}

/// All passes at one radius, in order of time.
std::vector<Pass> passes(const std::vector<Deepest>& column, double advance) {
  std::vector<Pass> all;
  for (std::size_t c = 0; c < column.size(); ++c)
    if (column[c].depth != never)
      for (int k = 0; k < revolutions; ++k)
        all.push_back({turn * k - column[c].phi, column[c].depth + advance * k, c, k});
  std::sort(all.begin(), all.end(), [](const Pass& a, const Pass& b) { return a.theta < b.theta; });
  return all;
}

/// Thickness that each cutter removes at one radius in revolution k, m.
std::vector<double> removed(const std::vector<Deepest>& column, double advance, int revolution) {
  std::vector<double> thickness(column.size(), 0.0);
  double height = never;
  for (const Pass& pass : passes(column, advance)) {
    const double cut = std::max(0.0, pass.depth - height);
    if (pass.revolution == revolution) thickness[pass.cutter] += cut;
    height = std::max(height, pass.depth);
  }
  return thickness;
}

void check_steady(const std::vector<double>& before, const std::vector<double>& last,
                  double advance) {
  for (std::size_t c = 0; c < last.size(); ++c)
    if (std::abs(last[c] - before[c]) > 1e-9 * advance)
      throw RunError("radial_plane_engagement: the cut is not steady after five revolutions");
}

}  // namespace

Engagement radial_plane_engagement(const bit::Bit& bit, double advance, double radial_spacing) {
  const std::size_t cutters = bit.cutters.size();
  Engagement e{std::vector<double>(cutters), std::vector<double>(cutters), 0.0,
               largest_radius(bit)};
  const double count = std::ceil(e.reach / radial_spacing);
  const double width = e.reach / count;
  Columns columns(static_cast<std::size_t>(count), std::vector<Deepest>(cutters));
  for (const bit::Part& part : bit.parts)
    if (takes_part(part)) offer_part(bit, part, advance, width, columns);

  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double circumference = turn * (static_cast<double>(i) + 0.5) * width;
    const std::vector<double> thickness = removed(columns[i], advance, revolutions - 1);
    check_steady(removed(columns[i], advance, revolutions - 2), thickness, advance);
    for (std::size_t c = 0; c < cutters; ++c) {
      e.mean_area[c] += thickness[c] * width;
      e.volume_per_revolution[c] += thickness[c] * width * circumference;
      e.total += thickness[c] * width * circumference;
    }
  }
  return e;
}

}  // namespace tdbd::reference
