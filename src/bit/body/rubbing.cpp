#include "bit/body/rubbing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bit/cutter/cutter.hpp"
#include "core/types.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Facets are measured between their corners if a corner touches at less than this times the given
/// advance.
constexpr double look_at = 2.0;

/// The rim at any radius, interpolated between the columns' centres. Not reached if a neighbouring
/// column is not reached.
RimReach reach_at(const std::vector<RimReach>& columns, double width, double r) {
  const double place = std::max(0.0, r / width - 0.5);
  const auto i = static_cast<std::size_t>(place);
  if (i + 1 >= columns.size() || !columns[i].reached() || !columns[i + 1].reached()) return {};
  const double w = place - static_cast<double>(i);
  return {std::lerp(columns[i].z, columns[i + 1].z, w),
          std::lerp(columns[i].azimuth, columns[i + 1].azimuth, w)};
}

/// The rock above one vertex of the body.
struct Above {
  double rock = -infinity;      ///< m, depth of the rock's surface
  double touching = -infinity;  ///< m per revolution
};

Above above(const RimReaches& rims, const Vec3& x_B, double advance) {
  const double r = x_B.head<2>().norm(), azimuth = std::atan2(x_B.y(), x_B.x());
  Above a;
  for (const std::vector<RimReach>& columns : rims.of_cutter) {
    const RimReach c = reach_at(columns, rims.width, r);
    if (!c.reached()) continue;
    const double share = (c.azimuth - azimuth) / full_turn, before = share - std::floor(share);
    a.rock = std::max(a.rock, c.z - before * advance);
    const double gap = c.z - x_B.z();
    if (before > 0.0)
      a.touching = std::max(a.touching, gap / before);
    else if (gap > 0.0)
      a.touching = infinity;
  }
  return a;
}

/// The fraction of a triangle in which a depth that is linear over it is positive.
double positive_share(std::array<double, 3> depth) {
  std::ranges::sort(depth);
  const auto [a, b, c] = depth;
  if (!(c > 0.0)) return 0.0;
  if (a >= 0.0) return 1.0;
  return b > 0.0 ? 1.0 - a * a / ((a - b) * (a - c)) : c * c / ((c - a) * (c - b));
}

/// Sample points of a facet, with neighbours at most `facet_step` apart, which divide it into small
/// triangles.
struct Facet {
  std::vector<Vec3> points_B;  ///< rows of 1, 2, ..., n + 1 points from its first corner
  int rows = 1;                ///< n
  double down = 0.0;  ///< m2, its area projected along the axis; negative if it faces upwards
};

Facet facet_of(const Part& part, const mesh::Triangle& t) {
  constexpr double facet_step = 1e-3;  // m
  std::array<Vec3, 3> x_B;
  for (std::size_t k = 0; k < 3; ++k) x_B[k] = part.X_BP * part.mesh_P.positions[at(t[k])];
  const Vec3 down = x_B[1] - x_B[0], across = x_B[2] - x_B[1];
  const double longest = std::max({down.norm(), across.norm(), (x_B[2] - x_B[0]).norm()});
  Facet f;
  f.rows = std::max(1, static_cast<int>(std::ceil(longest / facet_step)));
  f.down = mesh::area_vector(x_B[0], x_B[1], x_B[2]).z();
  for (int i = 0; i <= f.rows; ++i)
    for (int j = 0; j <= i; ++j) f.points_B.push_back(x_B[0] + (i * down + j * across) / f.rows);
  return f;
}

/// The fraction of a facet that touches at an advance below `advance`. `touching`: per point, m per
/// revolution; not finite where no cutter cuts.
double touching_share(int rows, const std::vector<double>& touching, double advance) {
  double share = 0.0;
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    const std::array<double, 3> by{advance - touching[a], advance - touching[b],
                                   advance - touching[c]};
    if (std::ranges::all_of(by, [](double d) { return std::isfinite(d); }))
      share += positive_share(by) / (rows * rows);
  };
  const auto place = [](int i, int j) {
    const auto row = static_cast<std::size_t>(i);
    return row * (row + 1) / 2 + static_cast<std::size_t>(j);
  };
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j <= i; ++j) {
      add(place(i, j), place(i + 1, j), place(i + 1, j + 1));
      if (j < i) add(place(i, j), place(i + 1, j + 1), place(i, j + 1));
    }
  return share;
}

std::vector<Vec3> vertices_of(const Part& part) {
  std::vector<Vec3> x_B(part.mesh_P.positions.size());
  std::ranges::transform(part.mesh_P.positions, x_B.begin(),
                         [&](const Vec3& x_P) { return Vec3(part.X_BP * x_P); });
  return x_B;
}

void note(const Vec3& x_B, const Above& a, Rubbing& least) {
  if (a.rock == -infinity) {
    ++least.over_uncut;
    return;
  }
  ++least.points;
  if (a.rock - x_B.z() < least.clearance) {
    least.clearance = a.rock - x_B.z();
    least.clearance_at_B = x_B;
  }
  if (std::max(0.0, a.touching) < least.touching_advance) {
    least.touching_advance = std::max(0.0, a.touching);
    least.touching_at_B = x_B;
  }
}

/// Whether a facet faces the rock and `near` is true for one of its corners. Only such facets are
/// measured between their corners.
template <class Near>
bool may_touch_rock(const std::vector<Vec3>& x_B, const mesh::Triangle& t, const Near& near) {
  return mesh::area_vector(x_B[at(t[0])], x_B[at(t[1])], x_B[at(t[2])]).z() > 0.0 &&
         std::ranges::any_of(t, near);
}

}  // namespace

Rubbing rubbing(const std::vector<Cutter>& cutters, const Part& part, double advance,
                double column_width) {
  if (cutters.empty()) return {};
  const RimReaches rims = rim_reaches(cutters, column_width);
  const std::vector<Vec3> x_B = vertices_of(part);
  std::vector<Above> over;
  Rubbing least;
  least.clearance = least.touching_advance = infinity;
  for (const Vec3& x : x_B) note(x, over.emplace_back(above(rims, x, advance)), least);
  const Rubbing of_vertices = least;
  const auto near = [&](int v) {
    return over[at(v)].touching < look_at * of_vertices.touching_advance;
  };
  for (const mesh::Triangle& t : part.mesh_P.triangles)
    if (may_touch_rock(x_B, t, near))
      for (const Vec3& x : facet_of(part, t).points_B) note(x, above(rims, x, advance), least);
  if (least.points == 0) least.clearance = least.touching_advance = 0.0;
  return least;
}

std::vector<double> rubbing_areas(const std::vector<Cutter>& cutters, const Part& part,
                                  const std::vector<double>& advances, double column_width) {
  std::vector<double> areas(advances.size(), 0.0), touching;
  if (advances.empty() || cutters.empty()) return areas;
  const RimReaches rims = rim_reaches(cutters, column_width);
  const std::vector<Vec3> x_B = vertices_of(part);
  std::vector<double> of_vertex(x_B.size());
  std::ranges::transform(x_B, of_vertex.begin(),
                         [&](const Vec3& x) { return above(rims, x, 0.0).touching; });
  const double most = look_at * std::ranges::max(advances);
  const auto near = [&](int v) { return of_vertex[at(v)] < most; };
  for (const mesh::Triangle& t : part.mesh_P.triangles) {
    if (!may_touch_rock(x_B, t, near)) continue;
    const Facet f = facet_of(part, t);
    touching.clear();
    for (const Vec3& x : f.points_B) touching.push_back(above(rims, x, 0.0).touching);
    for (std::size_t k = 0; k < advances.size(); ++k)
      areas[k] += f.down * touching_share(f.rows, touching, advances[k]);
  }
  return areas;
}

}  // namespace tdbd::bit
