#include "rock/cut/facet_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace tdbd::rock {
namespace {

/// One edge of a facet. The order of `ends` does not depend on the facet's orientation.
struct Side {
  std::array<double, 6> ends;
  int facet, edge;
};

std::array<const Vec3*, 3> corners(const mesh::Facet& f) { return {&f.a, &f.b, &f.c}; }

Side side_of(const mesh::Facet& f, int facet, std::size_t edge) {
  const Vec3 *p = corners(f)[edge], *q = corners(f)[(edge + 1) % 3];
  const auto key = [](const Vec3& x) { return std::tuple(x.x(), x.y(), x.z()); };
  if (key(*q) < key(*p)) std::swap(p, q);
  return {{p->x(), p->y(), p->z(), q->x(), q->y(), q->z()}, facet, static_cast<int>(edge)};
}

/// Whether the line between t = 0 and t = `reach` meets a box, with slack for rounding.
bool meets(const mesh::Box& box, const Vec3& x, const Vec3& u, double reach) {
  double enter = 0.0, leave = reach;
  for (int i = 0; i < 3; ++i) {
    const double slack = 1e-12 * (std::abs(box.lo[i]) + std::abs(box.hi[i]));
    const double lo = box.lo[i] - slack - x[i], hi = box.hi[i] + slack - x[i];
    if (u[i] == 0.0) {
      if (lo > 0.0 || hi < 0.0) return false;
      continue;
    }
    enter = std::max(enter, std::min(lo / u[i], hi / u[i]));
    leave = std::min(leave, std::max(lo / u[i], hi / u[i]));
  }
  return enter <= leave;
}

}  // namespace

FacetNeighbours neighbours_of(const mesh::TriangleTree& tree) {
  std::vector<Side> sides;
  sides.reserve(3 * tree.facets().size());
  for (std::size_t i = 0; i < tree.facets().size(); ++i)
    for (std::size_t e = 0; e < 3; ++e)
      sides.push_back(side_of(tree.facets()[i], static_cast<int>(i), e));
  std::ranges::sort(sides, [](const Side& a, const Side& b) {
    return std::tie(a.ends, a.facet, a.edge) < std::tie(b.ends, b.facet, b.edge);
  });
  FacetNeighbours across(tree.facets().size(), {-1, -1, -1});
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t last = i + 1;
    while (last < sides.size() && sides[last].ends == sides[i].ends) ++last;
    const auto set = [&](const Side& s, int facet) { across[at(s.facet)][at(s.edge)] = facet; };
    if (last == i + 2) {
      set(sides[i], sides[i + 1].facet);
      set(sides[i + 1], sides[i].facet);
    }
    i = last;
  }
  return across;
}

std::optional<double> walk_to_exit(const mesh::TriangleTree& tree, const FacetNeighbours& across,
                                   const Vec3& x, const Vec3& u, int& start, long& tested) {
  constexpr int most_steps = 48;
  constexpr double parallel = 1e-12;  // flatter crossings are left to the tree search
  int facet = start;
  for (int steps = 0; steps < most_steps && facet >= 0; ++steps) {
    ++tested;
    const auto hit = mesh::cross_plane(tree.facets()[at(facet)], x, u, parallel);
    if (!hit) return std::nullopt;
    const auto least = std::ranges::min_element(hit->beside);
    if (*least >= 0.0) {
      if (hit->out <= 0.0 || hit->s <= 0.0) return std::nullopt;
      start = facet;
      return hit->s;
    }
    facet = across[at(facet)][static_cast<std::size_t>(least - hit->beside.begin())];
  }
  return std::nullopt;
}

std::optional<FacetHit> first_facet(const mesh::TriangleTree& tree, const Vec3& x, const Vec3& u) {
  FacetHit first{-1, std::numeric_limits<double>::infinity()};
  tree.visit([&](const mesh::Box& box) { return meets(box, x, u, first.t); },
             [&](const mesh::Facet& f) {
               const auto hit = mesh::meet(f, x, u);
               if (hit && hit->margin >= 0.0 && hit->s > 0.0 && hit->s < first.t)
                 first = {static_cast<int>(&f - tree.facets().data()), hit->s};
               return true;
             });
  return first.facet < 0 ? std::nullopt : std::optional(first);
}

}  // namespace tdbd::rock
