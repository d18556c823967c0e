#include "mesh/search/inside.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace tdbd::mesh {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Ray directions that are not along an axis, face or diagonal a designer would choose.
const Vec3 directions[] = {{0.1237, 0.2711, 0.9545},   {-0.3319, 0.1173, 0.9360},
                           {0.2113, -0.4391, -0.8732}, {0.7713, 0.5381, 0.3394},
                           {-0.6151, 0.7333, -0.2895}, {0.3917, -0.9017, 0.1833}};

/// Whether the ray x + s / inverse, s >= 0, intersects the box.
bool ray_meets(const Box& box, const Vec3& x, const Vec3& inverse) {
  const Vec3 to_lo = (box.lo - x).cwiseProduct(inverse), to_hi = (box.hi - x).cwiseProduct(inverse);
  const double enter = to_lo.cwiseMin(to_hi).maxCoeff(), leave = to_lo.cwiseMax(to_hi).minCoeff();
  return leave >= 0.0 && enter <= leave * (1.0 + 1e-12);
}

/// Whether the number of crossings is odd; nothing if a crossing is too close to an edge to decide.
std::optional<bool> crosses_oddly(const TriangleTree& tree, const Vec3& x, const Vec3& d) {
  constexpr double edge = 1e-9;
  const Vec3 inverse = d.cwiseInverse();
  bool odd = false;
  const bool sure = tree.visit([&](const Box& box) { return ray_meets(box, x, inverse); },
                               [&](const Facet& f) {
                                 const auto hit = meet(f, x, d);
                                 if (!hit || hit->s <= 0.0 || hit->margin < -edge) return true;
                                 odd = !odd;
                                 return hit->margin > edge;
                               });
  return sure ? std::optional(odd) : std::nullopt;
}

/// Signed solid angle of a facet seen from x (Van Oosterom and Strackee, 1983).
double solid_angle(const Facet& f, const Vec3& x) {
  const Vec3 a = f.a - x, b = f.b - x, c = f.c - x;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2.0 * std::atan2(a.dot(b.cross(c)),
                          la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

bool winds_around(const TriangleTree& tree, const Vec3& x) {
  double sum = 0.0;
  for (const Facet& f : tree.facets()) sum += solid_angle(f, x);
  return sum > 2.0 * std::numbers::pi;
}

double squared_distance(const Box& box, const Vec3& x) {
  return (x - x.cwiseMax(box.lo).cwiseMin(box.hi)).squaredNorm();
}

}  // namespace

bool inside(const TriangleTree& closed, const Vec3& x) {
  if (!closed.box().contains(x)) return false;
  for (const Vec3& d : directions)
    if (const auto odd = crosses_oddly(closed, x, d)) return *odd;
  return winds_around(closed, x);
}

bool is_near(const TriangleTree& tree, const Vec3& x, double distance) {
  const double bound = distance * distance;
  return !tree.visit([&](const Box& box) { return squared_distance(box, x) < bound; },
                     [&](const Facet& f) { return squared_distance(f, x) >= bound; });
}

double distance(const TriangleTree& tree, const Vec3& x) {
  return distance_up_to(tree, x, infinity);
}

double distance_up_to(const TriangleTree& tree, const Vec3& x, double most) {
  double best = most * most;
  tree.visit([&](const Box& box) { return squared_distance(box, x) < best; },
             [&](const Facet& f) {
               best = std::min(best, squared_distance(f, x));
               return true;
             });
  return std::sqrt(best);
}

}  // namespace tdbd::mesh
