#include "rock/section/face_outline.hpp"

#include <algorithm>
#include <cmath>

#include "bit/cutter/cutter_frame.hpp"
#include "core/tolerance.hpp"

namespace tdbd::rock {
namespace {

/// Relative to the cutter's diameter. Far above rounding, far below a mesh's edge length.
constexpr double same_place = 1e-9;

double turns_left(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 u = b - a, v = c - a;
  return u.x() * v.y() - u.y() * v.x();
}

/// Appends to a chain that only turns left. Corners closer than `slack` to its lines are omitted.
void add_to_chain(ConvexPolygon& chain, std::size_t begin, const Vec2& x, double slack) {
  while (chain.size() >= begin + 2) {
    const Vec2 &a = chain[chain.size() - 2], &b = chain.back();
    if (turns_left(a, b, x) > slack * (x - a).norm()) break;
    chain.pop_back();
  }
  chain.push_back(x);
}

}  // namespace

/// Counter-clockwise from the leftmost corner: the lower chain, then the upper one.
ConvexPolygon convex_hull(std::vector<Vec2> points, double slack) {
  std::ranges::sort(points, [](const Vec2& a, const Vec2& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  ConvexPolygon hull;
  hull.reserve(2 * points.size());
  for (const Vec2& x : points) add_to_chain(hull, 0, x, slack);
  const std::size_t lower = hull.size() - 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add_to_chain(hull, lower, points[i], slack);
  hull.pop_back();
  return hull;
}

PolygonMoments moments(const ConvexPolygon& polygon) {
  PolygonMoments m;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i - 1] - polygon[0], b = polygon[i] - polygon[0];
    const double area = 0.5 * (a.x() * b.y() - a.y() * b.x());
    m.area += area;
    m.moment += area * (polygon[0] + (a + b) / 3.0);
  }
  return m;
}

void clip(const ConvexPolygon& polygon, const HalfPlane& h, ConvexPolygon& inside) {
  inside.clear();
  inside.reserve(polygon.size() + 1);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &p = polygon[i], &q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const double out_p = h.n.dot(p) - h.b, out_q = h.n.dot(q) - h.b;
    if (out_p <= 0.0) inside.push_back(p);
    if ((out_p < 0.0 && out_q > 0.0) || (out_p > 0.0 && out_q < 0.0))
      inside.push_back(p + out_p / (out_p - out_q) * (q - p));
  }
}

FaceOutline face_outline(const bit::Cutter& c, int index, const std::vector<bit::Part>& parts) {
  const double slack = same_place * c.diameter;
  FaceOutline face{c.X_BC * Pose{Mat3::Identity(), Vec3(bit::tip_C(c).x(), 0.0, 0.0)}, {}};
  std::vector<Vec2> points;
  for (const bit::Part& part : parts) {
    if (part.cutter != index) continue;
    const Pose X_FP = inverse(face.X_BF) * part.X_BP;
    for (const Vec3& x_P : part.mesh_P.positions) {
      const Vec3 x_F = X_FP * x_P;
      if (std::abs(x_F.x()) <= tolerance::face_plane * c.diameter)
        points.emplace_back(x_F.y(), x_F.z());
    }
  }
  if (points.size() >= 3) face.rim_F = convex_hull(std::move(points), slack);
  return face;
}

}  // namespace tdbd::rock
