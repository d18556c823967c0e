#include "bit/cone/tooth_mesh.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "core/angles.hpp"

namespace tdbd::bit {
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

}  // namespace tdbd::bit
