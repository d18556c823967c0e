#include "rock/cut/swept_mesh.hpp"

#include <algorithm>

#include "mesh/search/inside.hpp"

namespace tdbd::rock {
namespace {

mesh::Box box_of(const RelativePath& p) {
  mesh::Box box;
  box.add(p.q0_P);
  box.add(p.q1_P);
  return box;
}

/// Sorted: 0, the tau in (0, 1) at which the path crosses facets, and 1.
void find_crossings(const mesh::TriangleTree& solid, const RelativePath& p,
                    std::vector<double>& taus) {
  const mesh::Box reach = box_of(p);
  const Vec3 d = p.q1_P - p.q0_P;
  taus.assign({0.0, 1.0});
  solid.visit([&](const mesh::Box& box) { return box.overlaps(reach); },
              [&](const mesh::Facet& f) {
                constexpr double rim = 1e-11;  // a crossing that is found twice does no harm
                const auto hit = mesh::meet(f, p.q0_P, d);
                if (hit && hit->margin >= -rim && hit->s > 0.0 && hit->s < 1.0)
                  taus.push_back(hit->s);
                return true;
              });
  std::sort(taus.begin(), taus.end());
}

bool is_deep(const mesh::TriangleTree& solid, const Vec3& x, double depth) {
  return !mesh::is_near(solid, x, depth) && mesh::inside(solid, x);
}

void sort(std::vector<Levels>& intervals) {
  std::sort(intervals.begin(), intervals.end(), [](const Levels& a, const Levels& b) {
    return a.lo < b.lo || (a.lo == b.lo && a.hi < b.hi);
  });
}

void find_levels(const mesh::TriangleTree& solid, const Strip& strip, double same, MeshScratch& w) {
  w.intervals.clear();
  solid.visit([&](const mesh::Box& box) { return strip.meets(box); },
              [&](const mesh::Facet& f) {
                strip.levels_that_meet(f, same, w.ends, w.intervals);
                return true;
              });
  sort(w.intervals);
}

/// End of the connected set of sorted levels from t = 0 on. `closed`: a gap follows.
struct LevelsEnd {
  double t = 0.0;
  bool closed = false;
};

LevelsEnd end_of_levels(const mesh::TriangleTree& solid, const Strip& strip, double depth,
                        const std::vector<Levels>& intervals) {
  LevelsEnd end;
  for (const Levels& i : intervals) {
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

Ray middle_ray(const RelativePath& p) { return {0.5 * (p.q0_P + p.q1_P), 0.5 * (p.u0_P + p.u1_P)}; }

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

void find_facets(const mesh::TriangleTree& solid, const Strip& strip,
                 std::vector<const mesh::Facet*>& facets) {
  facets.clear();
  solid.visit([&](const mesh::Box& box) { return strip.meets(box); },
              [&](const mesh::Facet& f) {
                facets.push_back(&f);
                return true;
              });
}

bool crosses_any(const std::vector<const mesh::Facet*>& facets, const RelativePath& p) {
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

std::optional<Answer> exit_below(const mesh::TriangleTree& solid, const RelativePath& path,
                                 const Strip& strip, double most, double depth, MeshScratch& w) {
  find_facets(solid, strip.up_to(most), w.facets);
  const Ray ray = middle_ray(path);
  const auto ends = ends_of_ray(w.facets, ray, most);
  if (!ends || crosses_any(w.facets, path)) return std::nullopt;
  if (!ends->first_leaves || mesh::is_near(solid, ray.x, depth)) return Answer{};
  w.intervals.clear();
  for (const mesh::Facet* f : w.facets) strip.levels_that_meet(*f, depth, w.ends, w.intervals);
  sort(w.intervals);
  const LevelsEnd end = end_of_levels(solid, strip, depth, w.intervals);
  if (end.closed) return Answer{end.t};
  if (end.t + depth >= most || !ends->last_leaves) return std::nullopt;
  return Answer{end.t};
}

}  // namespace

bool is_swept(const mesh::TriangleTree& solid, const RelativePath& path, double depth,
              MeshScratch& scratch) {
  if (!solid.box().overlaps(box_of(path))) return false;
  const Vec3 d = path.q1_P - path.q0_P;
  std::vector<double>& taus = scratch.ends;
  find_crossings(solid, path, taus);
  for (std::size_t k = 1; k < taus.size(); ++k)
    if (is_deep(solid, path.q0_P + 0.5 * (taus[k - 1] + taus[k]) * d, depth)) return true;
  return taus.size() > 2 && is_deep(solid, path.q1_P, depth);
}

std::optional<double> exit_distance(const mesh::TriangleTree& solid, const RelativePath& path,
                                    double depth, MeshScratch& scratch) {
  if (!is_swept(solid, path, depth, scratch)) return std::nullopt;
  const Strip strip(path, solid.box());
  find_levels(solid, strip, depth, scratch);
  return end_of_levels(solid, strip, depth, scratch.intervals).t;
}

std::optional<double> exit_distance_by_walk(const mesh::TriangleTree& solid,
                                            const FacetNeighbours& across, const RelativePath& path,
                                            double depth, MeshScratch& scratch) {
  constexpr double beyond = 1.25;
  if (!solid.box().overlaps(box_of(path))) return std::nullopt;
  const double t = way_out(solid, across, middle_ray(path), scratch.walk);
  if (t > 0.0) {
    const double most = beyond * t + (path.q1_P - path.q0_P).norm();
    const Strip strip(path, solid.box());
    if (const auto answer = exit_below(solid, path, strip, most, depth, scratch)) {
      ++scratch.walk.answered;
      return answer->exit;
    }
  }
  return exit_distance(solid, path, depth, scratch);
}

}  // namespace tdbd::rock
