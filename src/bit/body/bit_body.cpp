#include "bit/body/bit_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "bit/bit.hpp"
#include "bit/cutter/cutter.hpp"
#include "core/compensated_sum.hpp"
#include "core/types.hpp"
#include "mesh/measures.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "mesh/shape/convex.hpp"

namespace tdbd::bit {
namespace {

constexpr int body_segments = 48;
constexpr double gage_length = 0.06;     ///< m, of full body above the highest tip
constexpr double shank_radius = 0.7;     ///< times the gage radius
constexpr double shank_length = 1.0;     ///< times the gage radius
constexpr double least_ring_gap = 1e-3;  ///< m, between two points of the meridian

/// Cutters of the profile, without back-ups, from the axis to the gage.
std::vector<Cutter> along_profile(std::vector<Cutter> cutters) {
  if (std::ranges::count(cutters, 0.0, &Cutter::under_exposure) > 0)
    std::erase_if(cutters, [](const Cutter& c) { return c.under_exposure > 0.0; });
  std::ranges::sort(cutters, {},
                    [](const Cutter& c) { return std::tuple(c.tip_radius, c.tip_height); });
  return cutters;
}

/// A ring about the bit's axis: x of a Ring is z of the bit.
Ring set_back(const Cutter& c, double setback) {
  const double depth = setback * c.diameter;
  return {c.tip_radius - depth * std::sin(c.profile_angle),
          -c.tip_height - depth * std::cos(c.profile_angle), body_segments};
}

/// The meridian under the cutters. If the profile is flat at the axis, the first cutter's slope is
/// kept.
std::vector<Ring> face_meridian(const std::vector<Cutter>& ordered, double setback) {
  const Ring first = set_back(ordered.front(), setback);
  const double slope = std::tan(std::clamp(ordered.front().profile_angle, -0.8, 0.0));
  std::vector<Ring> rings{{0.0, first.x + slope * first.radius, 1}};
  for (const Cutter& c : ordered) {
    const Ring next = set_back(c, setback);
    if (std::hypot(next.radius - rings.back().radius, next.x - rings.back().x) > least_ring_gap &&
        next.radius >= rings.back().radius)
      rings.push_back(next);
  }
  return rings;
}

/// Rotates rings about X to rings about the bit's z. A cyclic exchange of axes preserves the
/// orientation.
mesh::TriangleMesh about_z(mesh::TriangleMesh m) {
  for (Vec3& p : m.positions) p = Vec3(p.y(), p.z(), p.x());
  return m;
}

}  // namespace

Part bit_body(const std::vector<Cutter>& cutters, double setback, double density,
              double gage_radius) {
  std::vector<Ring> rings = face_meridian(along_profile(cutters), setback);
  const double highest_tip = std::ranges::max(cutters, {}, &Cutter::tip_height).tip_height;
  const double shoulder = -highest_tip - gage_length;
  const double end = shoulder - shank_length * gage_radius;
  rings.push_back({rings.back().radius, shoulder, body_segments});
  rings.push_back({shank_radius * gage_radius, shoulder, body_segments});
  rings.push_back({shank_radius * gage_radius, end, body_segments});
  rings.push_back({0.0, end, 1});
  Part body;
  body.name = "bit-body";
  body.kind = PartKind::bit_body;
  body.cutting = Cutting::never;
  body.mesh_P = about_z(surface_of_revolution(rings));
  body.density = density;
  return body;
}

namespace {

using Corners = std::array<Vec3, 3>;

mesh::Box box_of(const Corners& t) {
  mesh::Box box;
  for (const Vec3& x : t) box.add(x);
  return box;
}

/// Whether any point of the box can be vertically above the triangle, at smaller z.
bool stands_above(const mesh::Box& box, const mesh::Box& triangle) {
  return box.lo.x() < triangle.hi.x() && triangle.lo.x() < box.hi.x() &&
         box.lo.y() < triangle.hi.y() && triangle.lo.y() < box.hi.y() &&
         box.lo.z() < triangle.hi.z();
}

/// Signed volume of the part of a convex mesh that is vertically above a triangle whose normal has
/// n.z != 0.
double volume_above(mesh::TriangleMesh m, const Corners& t, const Vec3& n) {
  const double sign = n.z() > 0.0 ? 1.0 : -1.0;
  for (std::size_t k = 0; k < t.size() && !m.triangles.empty(); ++k) {
    const Vec3 edge = t[(k + 1) % t.size()] - t[k];
    const Vec3 out = sign * Vec3(edge.y(), -edge.x(), 0.0).normalized();
    m = mesh::clipped_convex(m, out, out.dot(t[k]));
  }
  if (m.triangles.empty()) return 0.0;
  const Vec3 down = sign * n.normalized();
  m = mesh::clipped_convex(m, down, down.dot(t[0]));
  return m.triangles.empty() ? 0.0 : mesh::enclosed_volume(m);
}

}  // namespace

double common_volume(const mesh::TriangleMesh& convex, const mesh::TriangleMesh& closed) {
  const mesh::Box box = mesh::bounding_box(convex);
  CompensatedSum sum;
  for (const mesh::Triangle& index : closed.triangles) {
    const Corners t{closed.positions[static_cast<std::size_t>(index[0])],
                    closed.positions[static_cast<std::size_t>(index[1])],
                    closed.positions[static_cast<std::size_t>(index[2])]};
    const Vec3 n = mesh::area_vector(t[0], t[1], t[2]);
    if (n.z() == 0.0 || !stands_above(box, box_of(t))) continue;
    sum.add(n.z() > 0.0 ? volume_above(convex, t, n) : -volume_above(convex, t, n));
  }
  return sum.value();
}

double cutters_in_body(const Bit& bit) {
  double volume = 0.0;
  for (const Part& body : bit.parts) {
    if (body.kind != PartKind::bit_body || body.density <= 0.0) continue;
    const mesh::TriangleMesh solid_B = mesh_B(body);
    for (const Part& part : bit.parts)
      if (part.cutter >= 0 && part.density > 0.0) volume += common_volume(mesh_B(part), solid_B);
  }
  return volume;
}

namespace {

bool encloses(const mesh::Box& outer, const mesh::Box& inner) {
  return outer.contains(inner.lo) && outer.contains(inner.hi);
}

}  // namespace

std::vector<std::pair<int, int>> enclosed_parts(const Bit& bit) {
  std::vector<mesh::TriangleMesh> meshes;
  std::vector<mesh::Box> boxes;
  for (const Part& part : bit.parts) {
    meshes.push_back(mesh_B(part));
    boxes.push_back(mesh::bounding_box(meshes.back()));
  }
  std::vector<std::optional<mesh::TriangleTree>> trees(meshes.size());
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < meshes.size(); ++i)
    for (std::size_t o = 0; o < meshes.size(); ++o) {
      const bool weigh = bit.parts[i].density > 0.0 && bit.parts[o].density > 0.0;
      if (i == o || !weigh || !encloses(boxes[o], boxes[i])) continue;
      if (!trees[o]) trees[o].emplace(meshes[o]);
      if (std::ranges::all_of(meshes[i].positions,
                              [&](const Vec3& x) { return mesh::inside(*trees[o], x); }))
        pairs.emplace_back(static_cast<int>(i), static_cast<int>(o));
    }
  return pairs;
}

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
