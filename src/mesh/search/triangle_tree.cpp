#include "mesh/search/triangle_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

namespace tdbd::mesh {
namespace {

constexpr int leaf_facets = 4;

Facet facet(const TriangleMesh& m, int i) {
  const Triangle& t = m.triangles[at(i)];
  const auto corner = [&](int k) { return m.positions[at(k)]; };
  return {corner(t[0]), corner(t[1]), corner(t[2])};
}

void add(Box& box, const Facet& f) {
  box.add(f.a);
  box.add(f.b);
  box.add(f.c);
}

/// Three times the centroid.
Vec3 middle(const Facet& f) { return f.a + f.b + f.c; }

}  // namespace

TriangleTree::TriangleTree(const TriangleMesh& m) {
  if (m.triangles.empty()) return;
  std::vector<int> order(m.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  facets_.reserve(order.size());
  build(order, 0, static_cast<int>(order.size()), m);
}

void TriangleTree::build(std::vector<int>& order, int first, int last, const TriangleMesh& m) {
  const std::size_t self = nodes_.size();
  nodes_.emplace_back();
  Box box, middles;
  for (int k = first; k < last; ++k) {
    const Facet f = facet(m, order[at(k)]);
    add(box, f);
    middles.add(middle(f));
  }
  nodes_[self].box = box;
  if (last - first <= leaf_facets) {
    nodes_[self].next = static_cast<int>(facets_.size());
    nodes_[self].facets = last - first;
    for (int k = first; k < last; ++k) facets_.push_back(facet(m, order[at(k)]));
    return;
  }
  Eigen::Index axis = 0;
  middles.size().maxCoeff(&axis);
  const auto key = [&](int i) { return std::pair(middle(facet(m, i))[axis], i); };
  std::sort(order.begin() + first, order.begin() + last,
            [&](int i, int j) { return key(i) < key(j); });
  const int half = first + (last - first) / 2;
  build(order, first, half, m);
  nodes_[self].next = static_cast<int>(nodes_.size());
  build(order, half, last, m);
}

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

namespace {

/// Computes distances of successive points. The distance of the last point bounds that of the next
/// one, which speeds up the search.
struct Walk {
  const TriangleTree& to;
  Vec3 last;
  double there;  ///< m, distance of the last point

  double distance_of(const Vec3& x) {
    constexpr double above = 1.0 + 1e-9, least = 1e-12;  // m: margin for rounding
    there = distance_up_to(to, x, (there + (x - last).norm()) * above + least);
    last = x;
    return there;
  }
};

/// Calls visit(x) for the centroid of each of the n * n equal parts of a triangle.
template <class Visit>
void visit_parts(const Facet& f, int n, Visit&& visit) {
  const auto point = [&](double i, double j) -> Vec3 {
    return f.a + (f.b - f.a) * (i / n) + (f.c - f.a) * (j / n);
  };
  constexpr double third = 1.0 / 3.0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      visit(point(i + third, j + third));
      if (i + j + 1 < n) visit(point(i + 2.0 * third, j + 2.0 * third));
    }
}

/// Number of parts per edge such that every point of the facet is at most `spacing` from a corner
/// or from the centroid of a part.
int parts_along(const Facet& f, double spacing) {
  const double longest = std::max({(f.b - f.a).norm(), (f.c - f.b).norm(), (f.a - f.c).norm()});
  return 1 + static_cast<int>(longest / spacing);
}

}  // namespace

SurfaceDistance distance_to(const TriangleMesh& from, const TriangleTree& to, double spacing) {
  SurfaceDistance found;
  if (from.triangles.empty()) return found;
  const Vec3& first = from.positions[at(from.triangles.front()[0])];
  Walk walk{to, first, distance(to, first)};
  for (const Triangle& t : from.triangles) {
    const Facet f{from.positions[at(t[0])], from.positions[at(t[1])], from.positions[at(t[2])]};
    for (const Vec3& x : {f.a, f.b, f.c})
      found.largest = std::max(found.largest, walk.distance_of(x));
    const int n = parts_along(f, spacing);
    const double area = 0.5 * (f.b - f.a).cross(f.c - f.a).norm() / (n * n);
    visit_parts(f, n, [&](const Vec3& x) {
      const double d = walk.distance_of(x);
      found.largest = std::max(found.largest, d);
      found.volume += d * area;
    });
  }
  return found;
}

}  // namespace tdbd::mesh
