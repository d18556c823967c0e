#include "rock/section/pressing_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mesh/search/triangle_tree.hpp"
#include "rock/cut/plane_strip.hpp"

namespace tdbd::rock {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double ridge = 1e-6;  // times the gap: within this, two surfaces are equally near

/// A smaller displacement along the normal counts as none, m. It is nearly an angle, because with a
/// fraction of the gap contacts would grow as the step shrinks.
double sliding(const PressingPart& part, const Vec3& move_P) {
  constexpr double angle = 1e-4;  // rad
  return angle * move_P.norm() + rest_tolerance(part);
}

/// The planes of a convex solid with the largest signed distance to x, to within `near`, m. If x is
/// farther outside than `bound`, only `out` is set, to a value above `bound`.
struct NearestPlanes {
  double out = -infinite;          ///< m, largest signed distance
  std::size_t farthest_plane = 0;  ///< the first of several
  std::size_t count = 0;
  std::array<int, mesh::most_planes> plane;
  std::array<double, mesh::most_planes> out_of;
};

TDBD_WIDE void find_nearest(const mesh::ConvexSolid& s, const Vec3& x, double near, double bound,
                            NearestPlanes& found) {
  double most = -infinite;
  std::size_t count = 0;
  for (std::size_t i = 0; i < s.b.size(); i += lanes) {
    WidePlanes p;
    load(s, i, p);
    const Wide out = p.x * x.x() + p.y * x.y() + p.z * x.z() - p.b;
    const auto decides = out >= most - near;
    if ((decides[0] | decides[1] | decides[2] | decides[3]) == 0) continue;
    for (std::size_t l = 0; l < lanes; ++l) {
      if (!(out[l] >= most - near) || i + l >= s.planes) continue;
      most = std::max(most, out[l]);
      found.plane[count] = static_cast<int>(i + l);
      found.out_of[count++] = out[l];
    }
    if (most > bound) break;
  }
  found.out = most;
  found.count = 0;
  if (most > bound) return;
  for (std::size_t k = count; k-- > 0;)
    if (found.out_of[k] == most) found.farthest_plane = at(found.plane[k]);
  for (std::size_t k = 0; k < count; ++k)
    if (found.out_of[k] >= most - near) found.plane[found.count++] = found.plane[k];
}

/// Distance of x from the surface of a solid, m, and whether that surface moved away.
struct NearestSide {
  double distance = infinite;
  bool is_lee = false;
};

/// See ContactOfPart::excluded_normal_P.
bool is_excluded_plane(const PressingPart& part, const Vec3& n_P) {
  constexpr double same_normal = 1e-12;  // of the cosine
  return part.excluded_normal_P.dot(n_P) > 1.0 - same_normal;
}

/// Whether all of the nearest planes moved away or are left out.
bool all_moved_away(const PressingPart& part, const mesh::ConvexSolid& s, const Vec3& x_P,
                    const NearestPlanes& nearest) {
  const Vec3 move_P = displacement_P(part, x_P);
  for (std::size_t k = 0; k < nearest.count; ++k)
    if (const Vec3 n_P = mesh::normal(s, at(nearest.plane[k]));
        !is_excluded_plane(part, n_P) && presses_or_slides(part, move_P, n_P))
      return false;
  return true;
}

NearestSide nearest_side(const PressingPart& part, const mesh::ConvexSolid& s, const Vec3& x_P,
                         double bound) {
  NearestPlanes nearest;
  find_nearest(s, x_P, ridge * part.gap, bound, nearest);
  return {std::abs(nearest.out), nearest.out <= bound && all_moved_away(part, s, x_P, nearest)};
}

NearestSide nearest_side(const PressingPart& part, const mesh::TriangleTree& tree,
                         const Vec3& x_P) {
  const Vec3 move_P = displacement_P(part, x_P);
  double pressing2 = infinite, lee2 = infinite;
  tree.visit(
      [&](const mesh::Box& box) {
        const Vec3 beside = x_P - x_P.cwiseMax(box.lo).cwiseMin(box.hi);
        return beside.squaredNorm() <= std::min(pressing2, lee2);
      },
      [&](const mesh::Facet& f) {
        const Vec3 n_P = (f.b - f.a).cross(f.c - f.a).normalized();
        double& least = presses_or_slides(part, move_P, n_P) ? pressing2 : lee2;
        least = std::min(least, mesh::squared_distance(f, x_P));
        return true;
      });
  const double pressing = std::sqrt(pressing2), lee = std::sqrt(lee2);
  return {std::min(pressing, lee), lee < pressing - ridge * part.gap};
}

/// Distance from the surface of a solid, m; for a convex solid, from its nearest plane.
double distance_from(const CuttingPart& solid, const Vec3& x_P) {
  if (solid.tree_P) return mesh::distance(*solid.tree_P, x_P);
  NearestPlanes nearest;
  find_nearest(solid.solid_P, x_P, 0.0, infinite, nearest);
  return std::abs(nearest.out);
}

bool is_near(const mesh::Box& box, const Vec3& x, double distance) {
  return (x - x.cwiseMax(box.lo).cwiseMin(box.hi)).squaredNorm() <= distance * distance;
}

}  // namespace

bool presses_or_slides(const PressingPart& part, const Vec3& move_P, const Vec3& n_P) {
  return n_P.dot(move_P) >= -sliding(part, move_P);
}

bool presses(const PressingPart& part, const Vec3& move_P, const Vec3& n_P) {
  return n_P.dot(move_P) > sliding(part, move_P);
}

bool is_on_lee_side(const PressingPart& part, const Vec3& x_P, std::size_t& nearest_solid) {
  NearestSide nearest;
  const std::size_t first = nearest_solid, count = part.solids.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (first + k) % count;
    const CuttingPart& solid = part.solids[i];
    const NearestSide side = solid.tree_P
                                 ? nearest_side(part, *solid.tree_P, x_P)
                                 : nearest_side(part, solid.solid_P, x_P, nearest.distance);
    if (side.distance >= nearest.distance) continue;
    nearest = side;
    nearest_solid = i;
  }
  return nearest.is_lee;
}

bool is_on_lee_side(const PressingPart& part, const Vec3& x_P) {
  std::size_t nearest_solid = 0;
  return is_on_lee_side(part, x_P, nearest_solid);
}

Touch touch(const PressingPart& part, const Vec3& x_P) {
  const mesh::ConvexSolid* s = convex(part);
  if (s == nullptr) return {is_on_lee_side(part, x_P), x_P};
  NearestPlanes nearest;
  find_nearest(*s, x_P, ridge * part.gap, infinite, nearest);
  const bool is_lee = all_moved_away(part, *s, x_P, nearest);
  if (std::abs(nearest.out) > part.gap) return {is_lee, x_P};
  return {is_lee, x_P - nearest.out * mesh::normal(*s, nearest.farthest_plane),
          std::max(nearest.out, 0.0)};
}

bool is_inside(const PressingPart& part, const Vec3& U_P) {
  const mesh::ConvexSolid* s = convex(part);
  if (s == nullptr) return false;
  NearestPlanes nearest;
  find_nearest(*s, U_P, 0.0, 0.0, nearest);
  return nearest.out <= 0.0;
}

Vec3 nearest_normal(const PressingPart& part, const Vec3& x_P) {
  const Vec3 move_P = displacement_P(part, x_P);
  Vec3 normal = Vec3::Zero();
  double most_into = -infinite;
  const auto take = [&](const Vec3& n_P) {
    const double into = n_P.dot(move_P);
    if (into <= most_into) return;
    most_into = into;
    normal = n_P;
  };
  const auto take_planes = [&](const mesh::ConvexSolid& s) {
    NearestPlanes nearest;
    find_nearest(s, x_P, ridge * part.gap, infinite, nearest);
    for (std::size_t k = 0; k < nearest.count; ++k) take(mesh::normal(s, at(nearest.plane[k])));
  };
  if (const mesh::ConvexSolid* s = convex(part)) {
    take_planes(*s);
    return normal;
  }
  double least = infinite;
  for (const CuttingPart& solid : part.solids) least = std::min(least, distance_from(solid, x_P));
  const double near = least + ridge * part.gap;
  for (const CuttingPart& solid : part.solids) {
    if (solid.tree_P)
      solid.tree_P->visit([&](const mesh::Box& box) { return is_near(box, x_P, near); },
                          [&](const mesh::Facet& f) {
                            if (mesh::squared_distance(f, x_P) <= near * near)
                              take((f.b - f.a).cross(f.c - f.a).normalized());
                            return true;
                          });
    else if (distance_from(solid, x_P) <= near)
      take_planes(solid.solid_P);
  }
  return normal;
}

double stress_share(const PressingPart& part, const Vec3& x_P, const Vec3& n_P) {
  if (!(part.ramp > 0.0)) return 1.0;
  const Vec3 move_P = displacement_P(part, x_P);
  const double into = n_P.dot(move_P), along = (move_P - into * n_P).norm();
  const double least = rest_tolerance(part);
  return std::clamp((into + least) / (part.ramp * along + least), 0.0, 1.0);
}

}  // namespace tdbd::rock
