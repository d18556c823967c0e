#include "mesh/facet.hpp"

namespace tdbd::mesh {
namespace {

double squared_distance_to_segment(const Vec3& a, const Vec3& b, const Vec3& x) {
  const Vec3 e = b - a;
  const double length2 = e.squaredNorm();
  const double s = length2 > 0.0 ? std::clamp(e.dot(x - a) / length2, 0.0, 1.0) : 0.0;
  return (x - a - s * e).squaredNorm();
}

}  // namespace

double squared_distance(const Facet& f, const Vec3& x) {
  const Vec3 n = (f.b - f.a).cross(f.c - f.a);
  const auto foot = meet(f, x, n);
  if (foot && foot->margin >= 0.0) return foot->s * foot->s * n.squaredNorm();
  return std::min({squared_distance_to_segment(f.a, f.b, x),
                   squared_distance_to_segment(f.b, f.c, x),
                   squared_distance_to_segment(f.c, f.a, x)});
}

}  // namespace tdbd::mesh
