#include "reference/literature/surface/planar_region.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::reference {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

template <class Measure>
double over_faces(const PlanarRegion& region, const Measure& signed_measure) {
  double sum = 0.0;
  for (const PlanarFace& face : region) {
    sum += std::abs(signed_measure(face.border));
    for (const Outline& cavity : face.cavities) sum -= std::abs(signed_measure(cavity));
  }
  return sum;
}

/// One side of the convex hull: of points in order, those at which it turns left.
void add_side(Outline& outline, const std::vector<Vec2>& in_order) {
  const std::size_t first = outline.size();
  for (const Vec2& x : in_order) {
    while (outline.size() >= first + 2) {
      const Vec2& last = outline.back();
      if (cross(last - outline[outline.size() - 2], x - last) > 0.0) break;
      outline.pop_back();
    }
    outline.push_back(x);
  }
  outline.pop_back();  // the next side starts with it
}

}  // namespace

double signed_area(const Outline& outline) {
  double doubled = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    doubled += cross(outline[i] - outline[0], outline[(i + 1) % outline.size()] - outline[0]);
  return doubled / 2.0;
}

double signed_moment(const Outline& outline) {
  double sum = 0.0;  // triangles from the first point: doubled area times sum of radii
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[0], &b = outline[i], &c = outline[(i + 1) % outline.size()];
    sum += cross(b - a, c - a) * (a.x() + b.x() + c.x());
  }
  return sum / 6.0;
}

double area(const PlanarRegion& region) { return over_faces(region, signed_area); }

double moment(const PlanarRegion& region) { return over_faces(region, signed_moment); }

bool encloses(const Outline& outline, const Vec2& x) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if ((a.x() > x.x()) == (b.x() > x.x())) continue;
    if (a.y() + (x.x() - a.x()) / (b.x() - a.x()) * (b.y() - a.y()) > x.y()) inside = !inside;
  }
  return inside;
}

bool encloses(const PlanarFace& face, const Vec2& x) {
  return encloses(face.border, x) &&
         std::ranges::none_of(face.cavities, [&](const Outline& c) { return encloses(c, x); });
}

Outline convex_outline(std::vector<Vec2> points) {
  std::ranges::sort(points, [](const Vec2& a, const Vec2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  Outline outline;
  if (points.size() < 3) return outline;
  add_side(outline, points);
  std::ranges::reverse(points);
  add_side(outline, points);
  if (outline.size() < 3) outline.clear();
  return outline;
}

}  // namespace tdbd::reference
