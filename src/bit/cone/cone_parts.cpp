#include "bit/cone/cone_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "bit/bit.hpp"
#include "core/types.hpp"

namespace tdbd::bit {
namespace {

double cross(const ShellPoint& o, const ShellPoint& a, const ShellPoint& b) {
  return (a.s - o.s) * (b.r - o.r) - (a.r - o.r) * (b.s - o.s);
}

double squared_distance(const ShellPoint& a, const ShellPoint& b, const ShellPoint& p) {
  const double ds = b.s - a.s, dr = b.r - a.r, length2 = ds * ds + dr * dr;
  const double along = length2 > 0.0 ? ((p.s - a.s) * ds + (p.r - a.r) * dr) / length2 : 0.0;
  const double t = std::clamp(along, 0.0, 1.0);
  return std::pow(p.s - a.s - t * ds, 2) + std::pow(p.r - a.r - t * dr, 2);
}

/// Whether a ray from p towards +r crosses the side.
bool crosses(const ShellPoint& a, const ShellPoint& b, const ShellPoint& p) {
  if ((a.s > p.s) == (b.s > p.s)) return false;
  return a.r + (p.s - a.s) * (b.r - a.r) / (b.s - a.s) > p.r;
}

/// The convex hull, by Andrew's monotone chains.
Meridian hull(Meridian points) {
  std::ranges::sort(points, {}, [](const ShellPoint& p) { return std::tuple(p.s, p.r); });
  Meridian chain;
  const auto add = [&](const ShellPoint& p, std::size_t keep) {
    while (chain.size() > keep && cross(chain[chain.size() - 2], chain.back(), p) <= 0.0)
      chain.pop_back();
    chain.push_back(p);
  };
  for (const ShellPoint& p : points) add(p, 1);
  const std::size_t lower = chain.size();
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) add(*p, lower);
  chain.pop_back();
  return chain;
}

}  // namespace

double signed_distance(const Meridian& solid, const ShellPoint& p) {
  double nearest = std::numeric_limits<double>::infinity();
  bool is_inside = false;
  for (std::size_t i = 0; i < solid.size(); ++i) {
    const ShellPoint &a = solid[i], &b = solid[(i + 1) % solid.size()];
    if (a.r != 0.0 || b.r != 0.0) nearest = std::min(nearest, squared_distance(a, b, p));
    is_inside = is_inside != crosses(a, b, p);
  }
  return is_inside ? -std::sqrt(nearest) : std::sqrt(nearest);
}

Meridian shell_meridian(const std::vector<ShellPoint>& shell) {
  Meridian m;
  if (shell.front().r > 0.0) m.push_back({shell.front().s, 0.0});
  m.insert(m.end(), shell.begin(), shell.end());
  if (shell.back().r > 0.0) m.push_back({shell.back().s, 0.0});
  return m;
}

Meridian swept_meridian(const mesh::TriangleMesh& convex_P, const Pose& X_KP) {
  Meridian points;
  for (const Vec3& x_P : convex_P.positions) {
    const Vec3 x_K = X_KP * x_P;
    const double angle = std::atan2(X_KP.p.y(), X_KP.p.x());
    const double inward = std::cos(angle) * x_K.x() + std::sin(angle) * x_K.y();
    points.push_back({-x_K.z(), std::hypot(x_K.x(), x_K.y())});
    points.push_back({-x_K.z(), std::max(0.0, inward)});
  }
  return hull(points);
}

namespace {

/// A segment of half length `half` along X, widened by `radius`, at height z.
struct Outline {
  double z, half, radius;
};

Vec3 corner(const Outline& o, int k, int n) {
  const double angle = full_turn * (k + 0.5) / n;
  const double c = std::cos(angle), s = std::sin(angle);
  return {(c > 0.0 ? o.half : -o.half) + o.radius * c, o.radius * s, o.z};
}

bool is_point(const Outline& o) { return o.radius == 0.0 && o.half == 0.0; }

void add_cap(int first, int n, bool up, std::vector<mesh::Triangle>& triangles) {
  for (int k = 1; k + 1 < n; ++k)
    triangles.push_back(up ? mesh::Triangle{first, first + k, first + k + 1}
                           : mesh::Triangle{first, first + k + 1, first + k});
}

/// Sides between the outline that starts at index `below` and the next one above, or a point.
void add_sides(int below, int n, bool to_point, std::vector<mesh::Triangle>& triangles) {
  const int above = below + n;
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    triangles.push_back({below + k, below + next, to_point ? above : above + next});
    if (!to_point) triangles.push_back({below + k, above + next, above + k});
  }
}

/// Outlines from the bottom up. Only the last may be a point.
mesh::TriangleMesh stack(const std::vector<Outline>& outlines, int n) {
  mesh::TriangleMesh m;
  add_cap(0, n, false, m.triangles);
  for (const Outline& o : outlines) {
    const int first = static_cast<int>(m.positions.size());
    if (first > 0) add_sides(first - n, n, is_point(o), m.triangles);
    for (int k = 0; k < (is_point(o) ? 1 : n); ++k)
      m.positions.push_back(is_point(o) ? Vec3(0.0, 0.0, o.z) : corner(o, k, n));
  }
  if (!is_point(outlines.back()))
    add_cap(static_cast<int>(m.positions.size()) - n, n, true, m.triangles);
  return m;
}

/// The cap of a ball about height z, from the polar angle `from` to the pole.
void add_ball(std::vector<Outline>& outlines, double z, double radius, double from, int facets) {
  const int rings = std::max(2, facets / 4);
  for (int k = 0; k < rings; ++k) {
    const double polar = from * (rings - k) / rings;
    outlines.push_back({z + radius * std::cos(polar), 0.0, radius * std::sin(polar)});
  }
  outlines.push_back({z + radius, 0.0, 0.0});
}

/// An outline with 4 corners that is a rectangle.
Outline rectangle(double z, double length, double width) {
  return {z, 0.5 * (length - width), width / std::numbers::sqrt2};
}

std::vector<Outline> hemispherical(const ToothShape& t, int facets) {
  std::vector<Outline> outlines{{-t.embedding, 0.0, 0.5 * t.diameter}};
  add_ball(outlines, t.protrusion - 0.5 * t.diameter, 0.5 * t.diameter, right_angle, facets);
  return outlines;
}

std::vector<Outline> conical(const ToothShape& t, int facets) {
  const double tangent = right_angle - t.half_angle, centre = t.protrusion - t.tip_radius;
  const double at_tangent = t.tip_radius * std::sin(tangent);
  const double shoulder = centre + t.tip_radius * std::cos(tangent) -
                          (0.5 * t.diameter - at_tangent) / std::tan(t.half_angle);
  std::vector<Outline> outlines{{-t.embedding, 0.0, 0.5 * t.diameter},
                                {shoulder, 0.0, 0.5 * t.diameter}};
  add_ball(outlines, centre, t.tip_radius, tangent, facets);
  return outlines;
}

/// The crest is shortened by the same factor as the inscribed shank. A crest as long as the
/// diameter would extend beyond the inscribed shank.
std::vector<Outline> chisel(const ToothShape& t, int facets) {
  const double half = 0.5 * (t.crest_length - t.crest_width) * std::cos(pi / facets);
  return {{-t.embedding, 0.0, 0.5 * t.diameter},
          {0.0, 0.0, 0.5 * t.diameter},
          {t.protrusion, half, 0.5 * t.crest_width}};
}

std::vector<Outline> milled(const ToothShape& t) {
  return {rectangle(-t.embedding, t.diameter, t.width), rectangle(0.0, t.diameter, t.width),
          rectangle(t.protrusion, t.crest_length, t.crest_width)};
}

}  // namespace

mesh::TriangleMesh tooth_mesh(const ToothShape& shape, int facets) {
  switch (shape.kind) {
    case ToothKind::hemispherical:
      return stack(hemispherical(shape, facets), facets);
    case ToothKind::conical:
      return stack(conical(shape, facets), facets);
    case ToothKind::chisel:
      return stack(chisel(shape, facets), facets);
    case ToothKind::milled_chisel:
      break;
  }
  return stack(milled(shape), 4);
}

namespace {

/// The outward normal of the piece of the profile from a to b.
ShellPoint piece_normal(const ShellPoint& a, const ShellPoint& b) {
  const double length = std::hypot(b.s - a.s, b.r - a.r);
  return {-(b.r - a.r) / length, (b.s - a.s) / length};
}

ShellPoint halfway(const ShellPoint& a, const ShellPoint& b) {
  const double length = std::hypot(a.s + b.s, a.r + b.r);
  return {(a.s + b.s) / length, (a.r + b.r) / length};
}

mesh::TriangleMesh turned(const Meridian& meridian, int segments) {
  std::vector<Ring> rings;
  rings.reserve(meridian.size());
  for (const ShellPoint& p : meridian) rings.push_back({p.r, -p.s, p.r > 0.0 ? segments : 1});
  mesh::TriangleMesh m = surface_of_revolution(rings);
  for (Vec3& x : m.positions) x = Vec3(x.y(), x.z(), x.x());  // rings are about X
  return m;
}

}  // namespace

ShellPlace shell_place(const std::vector<ShellPoint>& shell, double s) {
  if (s == shell.front().s && shell.front().r == 0.0) return {shell.front(), {-1.0, 0.0}};
  std::size_t i = 1;
  while (i + 1 < shell.size() && shell[i].s < s) ++i;
  const ShellPoint &a = shell[i - 1], &b = shell[i];
  const double t = (s - a.s) / (b.s - a.s);
  ShellPlace place{{s, a.r + t * (b.r - a.r)}, piece_normal(a, b)};
  if (s == b.s && i + 1 < shell.size())
    place.normal = halfway(place.normal, piece_normal(b, shell[i + 1]));
  return place;
}

mesh::TriangleMesh shell_mesh(const ConeLayout& cone) {
  return turned(shell_meridian(cone.shell), cone.segments);
}

std::vector<mesh::TriangleMesh> shell_pieces(const ConeLayout& cone) {
  std::vector<mesh::TriangleMesh> pieces;
  pieces.reserve(cone.shell.size());
  for (std::size_t i = 1; i < cone.shell.size(); ++i)
    pieces.push_back(turned(shell_meridian({cone.shell[i - 1], cone.shell[i]}), cone.segments));
  return pieces;
}

namespace {

Part cone_body(const Cone& cone, int index) {
  Part body;
  body.name = cone.name + "/body";
  body.kind = PartKind::cone;
  body.cutting = cone.layout.body;
  body.X_BP = cone.X_BK;
  body.mesh_P = shell_mesh(cone.layout);
  body.pieces_P = shell_pieces(cone.layout);
  body.density = cone.layout.density;
  body.cone = index;
  return body;
}

}  // namespace

Pose tooth_pose(const ConeLayout& cone, const ToothRow& row, double angle) {
  const ShellPlace at = shell_place(cone.shell, row.s);
  const double turn = std::atan2(at.normal.s, at.normal.r) + row.lean;
  const Vec3 z(std::cos(turn), 0.0, -std::sin(turn)), x(-std::sin(turn), 0.0, -std::cos(turn));
  Pose X_KT;
  X_KT.R << x, z.cross(x), z;
  X_KT.p = Vec3(at.point.r - row.sink * at.normal.r, 0.0, -at.point.s + row.sink * at.normal.s);
  return Pose{Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix(), Vec3::Zero()} * X_KT;
}

std::vector<Part> cone_parts(const Cone& cone, int index) {
  std::vector<Part> parts{cone_body(cone, index)};
  int row_number = 0;
  for (const ToothRow& row : cone.layout.rows) {
    ++row_number;
    const mesh::TriangleMesh mesh_T = tooth_mesh(row.shape, cone.layout.facets);
    for (std::size_t i = 0; i < row.angles.size(); ++i) {
      Part& tooth = parts.emplace_back();
      tooth.name = fmt::format("{}/row-{}/tooth-{}", cone.name, row_number, i + 1);
      tooth.kind = PartKind::tooth;
      tooth.X_BP = cone.X_BK * tooth_pose(cone.layout, row, row.angles[i]);
      tooth.mesh_P = mesh_T;
      tooth.density = row.shape.density;
      tooth.cone = index;
      tooth.row = row_number - 1;
    }
  }
  return parts;
}

Meridian row_meridian(const ConeLayout& cone, const ToothRow& row) {
  return swept_meridian(tooth_mesh(row.shape, cone.facets), tooth_pose(cone, row, 0.0));
}

std::vector<double> spaced_angles(int teeth, double first_angle,
                                  const std::vector<double>& pattern) {
  const auto ratio = [&](int i) {
    return pattern.empty() ? 1.0 : pattern[static_cast<std::size_t>(i) % pattern.size()];
  };
  double sum = 0.0;
  for (int i = 0; i < teeth; ++i) sum += ratio(i);
  std::vector<double> angles;
  double passed = 0.0;
  for (int i = 0; i < teeth; ++i) {
    const double angle = first_angle + full_turn * passed / sum;
    const double turned = angle - full_turn * std::floor(angle / full_turn);
    angles.push_back(turned < full_turn ? turned : 0.0);
    passed += ratio(i);
  }
  std::ranges::sort(angles);
  return angles;
}

}  // namespace tdbd::bit
