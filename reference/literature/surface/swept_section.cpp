#include "reference/literature/surface/swept_section.hpp"

#include <algorithm>

namespace tdbd::reference {

SweptBody swept_body(const mesh::TriangleMesh& convex_B, const Pose& X_B1B0) {
  SweptBody body;
  body.corners_B = convex_B.positions;
  const int n = static_cast<int>(convex_B.positions.size());
  for (const Vec3& x_B : convex_B.positions) body.corners_B.push_back(X_B1B0 * x_B);
  for (int v = 0; v < n; ++v) body.edges.push_back({v, v + n});
  for (const mesh::Triangle& t : convex_B.triangles)
    for (int i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3];
      if (a > b) continue;  // its other triangle adds it
      body.edges.push_back({a, b});
      body.edges.push_back({a + n, b + n});
    }
  for (const Vec3& x_B : body.corners_B) body.middle_B += x_B / (2.0 * n);
  for (const Vec3& x_B : body.corners_B)
    body.reach = std::max(body.reach, (x_B - body.middle_B).norm());
  return body;
}

std::vector<SweptBody> swept_bodies(const std::vector<CutterHull>& cutters, const Pose& X_B1B0) {
  std::vector<SweptBody> bodies;
  bodies.reserve(cutters.size());
  for (const CutterHull& c : cutters) {
    bodies.push_back(swept_body(c.hull_B, X_B1B0));
    bodies.back().cutter = c.cutter;
  }
  return bodies;
}

Outline section(const SweptBody& body, const std::vector<Vec3>& corners_W,
                const SpokePlane& plane) {
  std::vector<Vec2> passages;
  for (const auto& [a, b] : body.edges)
    if (const auto x = crossing(plane, corners_W[a], corners_W[b])) passages.push_back(*x);
  return convex_outline(std::move(passages));
}

}  // namespace tdbd::reference
