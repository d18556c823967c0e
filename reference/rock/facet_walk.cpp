#include "reference/rock/facet_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace tdbd::reference {
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

namespace {

mesh::Box box_of(const rock::RelativePath& p) {
  mesh::Box box;
  box.add(p.q0_P);
  box.add(p.q1_P);
  return box;
}

void sort(std::vector<rock::Levels>& intervals) {
  std::ranges::sort(intervals, [](const rock::Levels& a, const rock::Levels& b) {
    return a.lo < b.lo || (a.lo == b.lo && a.hi < b.hi);
  });
}

/// End of the connected set of sorted levels from t = 0 on. `closed`: a gap follows.
struct LevelsEnd {
  double t = 0.0;
  bool closed = false;
};

LevelsEnd end_of_levels(const mesh::TriangleTree& solid, const rock::Strip& strip, double depth,
                        const std::vector<rock::Levels>& intervals) {
  LevelsEnd end;
  for (const rock::Levels& i : intervals) {
    if (i.hi < end.t) continue;
    const bool is_gap = i.lo > end.t + depth;
    if (is_gap && !mesh::inside(solid, strip.at(0.5, 0.5 * (end.t + i.lo)))) {
      end.closed = true;
      break;
    }
    end.t = i.hi;
  }
  return end;
}

/// The ray at tau = 1/2.
struct Ray {
  Vec3 x, u;
};

Ray middle_ray(const rock::RelativePath& p) {
  return {0.5 * (p.q0_P + p.q1_P), 0.5 * (p.u0_P + p.u1_P)};
}

/// Where the ray leaves the solid: found by a walk from the last exit, otherwise by the tree. 0:
/// nowhere.
double way_out(const mesh::TriangleTree& solid, const FacetNeighbours& across, const Ray& ray,
               WalkMemory& memory) {
  if (memory.of != &solid) {
    memory.of = &solid;
    memory.facet = 0;
  }
  ++memory.tried;
  long tested = 0;
  const auto t = walk_to_exit(solid, across, ray.x, ray.u, memory.facet, tested);
  memory.facets_tested += tested;
  if (t) {
    ++memory.found;
    memory.facets_tested_by_found += tested;
    return *t;
  }
  const auto first = first_facet(solid, ray.x, ray.u);
  if (!first) return 0.0;
  memory.facet = first->facet;
  return first->t;
}

/// The first and last facets that the ray meets. Nothing if the ray passes too close to a rim to be
/// sure.
struct Ends {
  double first = 0.0, last = 0.0;
  bool first_leaves = false, last_leaves = false;
};

std::optional<Ends> ends_of_ray(const std::vector<const mesh::Facet*>& facets, const Ray& ray,
                                double most) {
  constexpr double rim = 1e-9;
  Ends ends{most, 0.0};
  for (const mesh::Facet* f : facets) {
    const auto hit = mesh::meet(*f, ray.x, ray.u);
    if (!hit || hit->s <= 0.0 || hit->s >= most || hit->margin < -rim) continue;
    if (hit->margin < rim) return std::nullopt;
    const bool leaves = (f->b - f->a).cross(f->c - f->a).dot(ray.u) > 0.0;
    if (hit->s < ends.first) ends.first = hit->s, ends.first_leaves = leaves;
    if (hit->s > ends.last) ends.last = hit->s, ends.last_leaves = leaves;
  }
  return ends.last > 0.0 ? std::optional(ends) : std::nullopt;
}

void find_facets(const mesh::TriangleTree& solid, const rock::Strip& strip,
                 std::vector<const mesh::Facet*>& facets) {
  facets.clear();
  solid.visit([&](const mesh::Box& box) { return strip.meets(box); },
              [&](const mesh::Facet& f) {
                facets.push_back(&f);
                return true;
              });
}

bool crosses_any(const std::vector<const mesh::Facet*>& facets, const rock::RelativePath& p) {
  constexpr double rim = 1e-11;
  const Vec3 d = p.q1_P - p.q0_P;
  return std::ranges::any_of(facets, [&](const mesh::Facet* f) {
    const auto hit = mesh::meet(*f, p.q0_P, d);
    return hit && hit->margin >= -rim && hit->s > 0.0 && hit->s < 1.0;
  });
}

/// The result of exit_distance from the facets near the strip below `most` alone. Nothing if these
/// facets do not determine it.
struct Answer {
  std::optional<double> exit;
};

std::optional<Answer> exit_below(const mesh::TriangleTree& solid, const rock::RelativePath& path,
                                 const rock::Strip& strip, double most, double depth,
                                 WalkScratch& w) {
  find_facets(solid, strip.up_to(most), w.facets);
  const Ray ray = middle_ray(path);
  const auto ends = ends_of_ray(w.facets, ray, most);
  if (!ends || crosses_any(w.facets, path)) return std::nullopt;
  if (!ends->first_leaves || mesh::is_near(solid, ray.x, depth)) return Answer{};
  w.mesh.intervals.clear();
  for (const mesh::Facet* f : w.facets)
    strip.levels_that_meet(*f, depth, w.mesh.ends, w.mesh.intervals);
  sort(w.mesh.intervals);
  const LevelsEnd end = end_of_levels(solid, strip, depth, w.mesh.intervals);
  if (end.closed) return Answer{end.t};
  if (end.t + depth >= most || !ends->last_leaves) return std::nullopt;
  return Answer{end.t};
}

}  // namespace

std::optional<double> exit_distance_by_walk(const mesh::TriangleTree& solid,
                                            const FacetNeighbours& across,
                                            const rock::RelativePath& path, double depth,
                                            WalkScratch& scratch) {
  constexpr double beyond = 1.25;
  if (!solid.box().overlaps(box_of(path))) return std::nullopt;
  const double t = way_out(solid, across, middle_ray(path), scratch.walk);
  if (t > 0.0) {
    const double most = beyond * t + (path.q1_P - path.q0_P).norm();
    const rock::Strip strip(path, solid.box());
    if (const auto answer = exit_below(solid, path, strip, most, depth, scratch)) {
      ++scratch.walk.answered;
      return answer->exit;
    }
  }
  return rock::exit_distance(solid, path, depth, scratch.mesh);
}

}  // namespace tdbd::reference
