#include "rock/section/stress_share.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/search/inside.hpp"

namespace tdbd::rock {
namespace {

/// How far the planes' nearest is from x; positive outside.
double greatest_out(const mesh::ConvexSolid& s, const Vec3& x_P) {
  double out = std::numeric_limits<double>::lowest();
  for (std::size_t i = 0; i < s.planes; ++i)
    out = std::max(out, mesh::normal(s, i).dot(x_P) - s.b[i]);
  return out;
}

/// m, from the surface of a solid; of a convex one to its nearest plane.
double distance_from(const CuttingPart& solid, const Vec3& x_P) {
  return solid.tree_P ? mesh::distance(*solid.tree_P, x_P)
                      : std::abs(greatest_out(solid.solid_P, x_P));
}

bool is_near(const mesh::Box& box, const Vec3& x, double distance) {
  return (x - x.cwiseMax(box.lo).cwiseMin(box.hi)).squaredNorm() <= distance * distance;
}

}  // namespace

double stress_share(const PressingPart& part, const Vec3& x_P, const Vec3& n_P) {
  if (!(part.ramp > 0.0)) return 1.0;
  const Vec3 move_P = displacement_P(part, x_P);
  const double into = n_P.dot(move_P), along = (move_P - into * n_P).norm();
  const double least = standing(part);
  return std::clamp((into + least) / (part.ramp * along + least), 0.0, 1.0);
}

Vec3 nearest_normal(const PressingPart& part, const Vec3& x_P) {
  constexpr double ridge = 1e-6;  // of the gap
  double least = std::numeric_limits<double>::max();
  for (const CuttingPart& solid : part.solids) least = std::min(least, distance_from(solid, x_P));
  const double near = least + ridge * part.gap;
  const Vec3 move_P = displacement_P(part, x_P);
  Vec3 normal = Vec3::Zero();
  double most_into = std::numeric_limits<double>::lowest();
  const auto take = [&](const Vec3& n_P) {
    const double into = n_P.dot(move_P);
    if (into <= most_into) return;
    most_into = into;
    normal = n_P;
  };
  for (const CuttingPart& solid : part.solids) {
    if (solid.tree_P) {
      solid.tree_P->visit([&](const mesh::Box& box) { return is_near(box, x_P, near); },
                          [&](const mesh::Facet& f) {
                            if (mesh::squared_distance(f, x_P) <= near * near)
                              take((f.b - f.a).cross(f.c - f.a).normalized());
                            return true;
                          });
    } else if (distance_from(solid, x_P) <= near) {
      const double out = greatest_out(solid.solid_P, x_P) - ridge * part.gap;
      for (std::size_t i = 0; i < solid.solid_P.planes; ++i)
        if (const Vec3 n = mesh::normal(solid.solid_P, i); n.dot(x_P) - solid.solid_P.b[i] >= out)
          take(n);
    }
  }
  return normal;
}

}  // namespace tdbd::rock
