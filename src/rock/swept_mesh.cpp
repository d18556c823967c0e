#include "rock/swept_mesh.hpp"

#include <algorithm>

#include "mesh/inside.hpp"

namespace tdbd::rock {
namespace {

mesh::Box box_of(const RelativePath& p) {
  mesh::Box box;
  box.add(p.q0_P);
  box.add(p.q1_P);
  return box;
}

/// 0, the places in (0, 1) where the path crosses facets, and 1, sorted.
void find_crossings(const mesh::TriangleTree& solid, const RelativePath& p,
                    std::vector<double>& taus) {
  const mesh::Box reach = box_of(p);
  const Vec3 d = p.q1_P - p.q0_P;
  taus.assign({0.0, 1.0});
  solid.visit([&](const mesh::Box& box) { return box.overlaps(reach); },
              [&](const mesh::Facet& f) {
                constexpr double rim = 1e-11;  // a crossing found twice does no harm
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

void find_levels(const mesh::TriangleTree& solid, const Strip& strip, double same, MeshScratch& w) {
  w.intervals.clear();
  solid.visit([&](const mesh::Box& box) { return strip.meets(box); },
              [&](const mesh::Facet& f) {
                strip.levels_that_meet(f, same, w.ends, w.intervals);
                return true;
              });
  std::sort(w.intervals.begin(), w.intervals.end(), [](const Levels& a, const Levels& b) {
    return a.lo < b.lo || (a.lo == b.lo && a.hi < b.hi);
  });
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
  double end = 0.0;
  for (const Levels& i : scratch.intervals) {
    if (i.hi < end) continue;
    const bool is_gap = i.lo > end + depth;
    if (is_gap && !mesh::inside(solid, strip.at(0.5, 0.5 * (end + i.lo)))) break;
    end = i.hi;
  }
  return end;
}

}  // namespace tdbd::rock
