#include "mesh/shape/polygon.hpp"

#include <algorithm>

#include "mesh/measures.hpp"

namespace tdbd::mesh {
namespace {

/// A triangle of lower quality has no area up to rounding, as in check_closed.
constexpr double flat_quality = 1e-14;

/// A polygon being cut. The corners that are left are counter-clockwise about `normal`.
struct Ring {
  const std::vector<Vec3>& points;
  Vec3 normal;
  std::vector<int> corners;

  const Vec3& x(std::size_t k) const { return points[at(corners[k % corners.size()])]; }
};

/// Twice the area of a triangle as seen along the normal; positive if it is counter-clockwise.
double turn(const Vec3& normal, const Vec3& a, const Vec3& b, const Vec3& c) {
  return normal.dot((b - a).cross(c - a));
}

bool is_proper(const Vec3& normal, const Vec3& a, const Vec3& b, const Vec3& c) {
  return turn(normal, a, b, c) > 0.0 && triangle_quality(a, b, c) >= flat_quality;
}

/// Area vector of a polygon (Newell). Its first corner is the origin, which keeps rounding small.
Vec3 polygon_area(const std::vector<Vec3>& points, const std::vector<int>& corners) {
  Vec3 sum = Vec3::Zero();
  const Vec3& a = points[at(corners[0])];
  for (std::size_t k = 2; k < corners.size(); ++k)
    sum += area_vector(a, points[at(corners[k - 1])], points[at(corners[k])]);
  return sum;
}

/// Whether the triangle at corner k can be cut off: it is proper, and no other corner is in it or
/// on its sides. Corners at the position of one of its own do not count: two parts of a boundary
/// may touch, as in a polygon around a hole.
bool is_ear(const Ring& ring, std::size_t k) {
  const std::size_t n = ring.corners.size();
  const Vec3 &a = ring.x(k + n - 1), &b = ring.x(k), &c = ring.x(k + 1);
  if (!is_proper(ring.normal, a, b, c)) return false;
  for (std::size_t other = 2; other + 1 < n; ++other) {
    const Vec3& p = ring.x(k + other);
    if (p == a || p == b || p == c) continue;
    if (turn(ring.normal, a, b, p) >= 0.0 && turn(ring.normal, b, c, p) >= 0.0 &&
        turn(ring.normal, c, a, p) >= 0.0)
      return false;
  }
  return true;
}

/// Cuts ears until a triangle is left. Returns whether that succeeded.
bool cut_ears(Ring ring, std::vector<Triangle>& triangles) {
  for (std::size_t k = 0, failed = 0; ring.corners.size() > 3;) {
    const std::size_t n = ring.corners.size();
    if (failed == n) return false;
    if (!is_ear(ring, k)) {
      k = (k + 1) % n;
      ++failed;
      continue;
    }
    triangles.push_back(
        {ring.corners[(k + n - 1) % n], ring.corners[k], ring.corners[(k + 1) % n]});
    ring.corners.erase(ring.corners.begin() + static_cast<std::ptrdiff_t>(k));
    k %= n - 1;  // the corner after the ear, so that ears are not all cut at one corner
    failed = 0;
  }
  triangles.push_back({ring.corners[0], ring.corners[1], ring.corners[2]});
  return is_proper(ring.normal, ring.x(0), ring.x(1), ring.x(2));
}

}  // namespace

void triangulate_polygon(const std::vector<Vec3>& points, const std::vector<int>& corners,
                         std::vector<Triangle>& triangles) {
  constexpr std::size_t most_corners = 2000;  // the run time grows with the square
  const std::size_t before = triangles.size(), n = corners.size();
  const auto fan = [&] {
    triangles.resize(before);
    for (std::size_t k = 2; k < n; ++k)
      triangles.push_back({corners[0], corners[k - 1], corners[k]});
  };
  fan();
  if (n == 3) return;
  const Vec3 normal = polygon_area(points, corners).stableNormalized();
  const bool fan_is_proper =
      std::all_of(triangles.begin() + static_cast<std::ptrdiff_t>(before), triangles.end(),
                  [&](const Triangle& t) {
                    return is_proper(normal, points[at(t[0])], points[at(t[1])], points[at(t[2])]);
                  });
  if (fan_is_proper || n > most_corners) return;
  triangles.resize(before);
  if (!cut_ears({points, normal, corners}, triangles)) fan();
}

}  // namespace tdbd::mesh
