#include "rock/section/convex_polygon.hpp"

namespace tdbd::rock {

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

}  // namespace tdbd::rock
