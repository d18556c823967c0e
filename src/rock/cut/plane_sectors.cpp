#include "rock/cut/plane_sectors.hpp"

#include <algorithm>
#include <limits>

namespace tdbd::rock {
namespace {

using Polygon = std::vector<Vec3>;
constexpr std::size_t no_end = std::numeric_limits<std::size_t>::max();

/// Clips a polygon to n . x <= b. `kept`: buffer.
void cut(const Vec3& n, double b, Polygon& polygon, Polygon& kept) {
  kept.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &x = polygon[i], &y = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const double x_out = n.dot(x) - b, y_out = n.dot(y) - b;
    if (x_out <= 0.0) kept.push_back(x);
    if ((x_out > 0.0) != (y_out > 0.0)) kept.push_back(x + x_out / (x_out - y_out) * (y - x));
  }
  std::swap(polygon, kept);
}

/// Lengths that scale with the solid, m.
struct Lengths {
  double far;    ///< beyond all corners
  double depth;  ///< of the axis inside the solid
  double slack;
  double beyond;  ///< PlaneSectors::beyond
};

Lengths lengths_for(double size) { return {10.0 * size, 0.01 * size, 1e-6 * size, 0.1 * size}; }

/// The facet of plane i, enlarged as if all other planes were farther out by the slack, and plane
/// `moved` farther out by PlaneSectors::beyond.
Polygon facet(const mesh::ConvexSolid& s, std::size_t i, std::size_t moved, const Lengths& by) {
  const Vec3 n = mesh::normal(s, i), u = by.far * n.unitOrthogonal(), v = n.cross(u),
             middle = s.b[i] * n;
  Polygon polygon{middle + u, middle + v, middle - u, middle - v}, room;
  for (std::size_t k = 0; k < s.planes && !polygon.empty(); ++k)
    if (k != i)
      cut(mesh::normal(s, k), s.b[k] + by.slack + (k == moved ? by.beyond : 0.0), polygon, room);
  return polygon;
}

/// The part of the x axis that is deeper in the solid than `depth`; lo > hi if there is none.
struct AxisPart {
  double lo, hi;
};

AxisPart axis_inside(const mesh::ConvexSolid& s, double depth, double far) {
  double lo = -far, hi = far;
  for (std::size_t i = 0; i < s.planes; ++i) {
    const double room = s.b[i] - depth;
    if (s.nx[i] > 0.0) hi = std::min(hi, room / s.nx[i]);
    if (s.nx[i] < 0.0) lo = std::max(lo, room / s.nx[i]);
    if (s.nx[i] == 0.0 && room < 0.0) return {far, -far};
  }
  return {lo, hi};
}

bool is_end(const mesh::ConvexSolid& s, std::size_t i) { return std::abs(s.nx[i]) > 0.9; }

/// The angle in the y-z plane at which sector k of PlaneSectors::towards begins.
double first_angle(int k) {
  const double a = 4.0 * k / PlaneSectors::count, p = a < 2.0 ? a - 1.0 : 3.0 - a;
  return std::atan2(p, (a < 2.0 ? 1.0 : -1.0) * (1.0 - std::abs(p)));
}

/// The facets of one plane: of the solid, and of the solid with each end moved.
using Facets = std::vector<Polygon>;

std::vector<Facets> facets_of(const mesh::ConvexSolid& s, const Lengths& by) {
  std::vector<std::size_t> moved{no_end};
  for (std::size_t i = 0; i < s.planes; ++i)
    if (is_end(s, i)) moved.push_back(i);
  std::vector<Facets> all(s.planes);
  for (std::size_t i = 0; i < s.planes; ++i)
    for (const std::size_t k : moved)
      if (k != i) all[i].push_back(facet(s, i, k, by));
  return all;
}

/// Sides of the wedge of sector k, widened by `margin` (rad) on each side.
std::array<double, 4> wedge(int k, double margin) {
  const double lo = first_angle(k) - margin, hi = first_angle(k + 1) + margin;
  return {-std::sin(lo), std::cos(lo), std::sin(hi), -std::cos(hi)};
}

bool meets(const Polygon& facet, const std::array<double, 4>& sides, double slack) {
  Polygon polygon = facet, room;
  cut(Vec3(0.0, -sides[0], -sides[1]), slack, polygon, room);
  cut(Vec3(0.0, -sides[2], -sides[3]), slack, polygon, room);
  return !polygon.empty();
}

PlaneSector make_sector(const mesh::ConvexSolid& s, const std::vector<Facets>& facets, double slack,
                        const std::array<double, 4>& sides) {
  PlaneSector sector{sides, {}, {}, 0};
  for (std::size_t i = 0; i < s.planes; ++i) {
    if (!std::ranges::any_of(facets[i], [&](const Polygon& f) { return meets(f, sides, slack); }))
      continue;
    if (is_end(s, i) && sector.plane.size() < PlaneSectors::most_rows)
      sector.ends |= 1U << sector.plane.size();
    sector.plane.push_back(static_cast<std::uint16_t>(i));
    for (const double x : {s.nx[i], s.ny[i], s.nz[i], s.b[i]}) sector.rows.push_back(x);
  }
  return sector;
}

/// Computes the core: the cylinder that stays inside every plane that some sector lacks, by the
/// slack.
void find_core(const mesh::ConvexSolid& s, const Lengths& by, PlaneSectors& all) {
  const AxisPart axis = axis_inside(s, 0.0, by.far);
  all.core_lo = axis.lo - by.slack;
  all.core_hi = axis.hi + by.slack;
  all.core_radius = by.far;
  for (std::size_t i = 0; i < s.planes; ++i) {
    const auto has = [&](const PlaneSector& sector) {
      return std::ranges::binary_search(sector.plane, static_cast<std::uint16_t>(i));
    };
    if (std::ranges::all_of(all.sectors, has)) continue;
    const double room = s.b[i] - by.slack - std::max(s.nx[i] * all.core_lo, s.nx[i] * all.core_hi);
    all.core_radius = std::min(all.core_radius, room / std::hypot(s.ny[i], s.nz[i]));
  }
}

}  // namespace

PlaneSectors plane_sectors(const mesh::ConvexSolid& s, double size) {
  constexpr std::size_t few = 16, most_ends = 4;
  constexpr double margin = 0.1;  // rad
  const Lengths by = lengths_for(size);
  std::size_t ends = 0;
  for (std::size_t i = 0; i < s.planes; ++i) ends += is_end(s, i) ? 1 : 0;
  if (s.planes <= few || ends > most_ends) return {};
  if (const AxisPart axis = axis_inside(s, by.depth, size); axis.lo > axis.hi) return {};
  const std::vector<Facets> facets = facets_of(s, by);
  PlaneSectors all;
  all.size = size;
  all.beyond = by.beyond;
  for (int k = 0; k < PlaneSectors::count; ++k) {
    all.sectors.push_back(make_sector(s, facets, by.slack, wedge(k, margin)));
    all.rows = std::max(all.rows, all.sectors.back().plane.size());
  }
  if (all.rows > PlaneSectors::most_rows) return {};
  find_core(s, by, all);
  for (PlaneSector& sector : all.sectors)
    while (sector.rows.size() < 4 * all.rows)
      for (const double x : {0.0, 0.0, 0.0, std::numeric_limits<double>::infinity()})
        sector.rows.push_back(x);
  return all;
}

}  // namespace tdbd::rock
