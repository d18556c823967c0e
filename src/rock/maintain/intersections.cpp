#include "rock/maintain/intersections.hpp"

#include <algorithm>

#include "core/sort_unique.hpp"

namespace tdbd::rock {
namespace {

using mesh::NamedFacet;

mesh::Box box_of(const NamedFacet& f) {
  mesh::Box box;
  for (const Vec3& x : f.x) box.add(x);
  return box;
}

bool has(const mesh::Triangle& t, int v) { return t[0] == v || t[1] == v || t[2] == v; }

void clear(Patch& patch) {
  patch.facets.clear();
  patch.replaced.clear();
}

/// The facet with one corner named and placed anew.
void rename(NamedFacet& f, int from, int to, const Vec3& x_W) {
  for (std::size_t i = 0; i < 3; ++i)
    if (f.names[i] == from) {
      f.names[i] = to;
      f.x[i] = x_W;
    }
}

/// The triangles of the surface near the patch that stay, by their boxes and nearest vertices.
void find_near(const Rock& rock, const Patch& patch, double longest_edge, IntersectionWork& work) {
  constexpr double circumradius = 0.6;  // of an equilateral triangle, over its edge; rounded up
  const mesh::Surface& s = rock.surface;
  work.triangles.clear();
  work.seen.resize(s.triangles.size(), 0);
  ++work.stamp;
  for (const int t : patch.replaced) work.seen[at(t)] = work.stamp;
  Region region;
  for (const NamedFacet& f : patch.facets)
    for (const Vec3& x : f.x) region.box.add(x);
  const mesh::Box patch_box = region.box;
  region.box.lo.array() -= circumradius * longest_edge;
  region.box.hi.array() += circumradius * longest_edge;
  rock.grid.visit(region, work.chains, [&](const VertexGrid::Block& block) {
    for (std::size_t i = 0; i < at(block.count); ++i)
      mesh::visit_corners(s, block.v[i], [&](int c) {
        const int t = c / 3;
        if (work.seen[at(t)] == work.stamp) return;
        work.seen[at(t)] = work.stamp;
        if (box_of(named_facet(s, t)).overlaps(patch_box)) work.triangles.push_back(t);
      });
  });
}

}  // namespace

mesh::NamedFacet named_facet(const mesh::Surface& s, int t) {
  const mesh::Triangle& v = s.triangles[at(t)];
  return {v, {s.position(v[0]), s.position(v[1]), s.position(v[2])}};
}

void take_triangle(const mesh::Surface& s, int t, Patch& patch) {
  clear(patch);
  patch.replaced.push_back(t);
  patch.facets.push_back(named_facet(s, t));
}

void take_stars(const mesh::Surface& s, const std::vector<int>& vertices, Patch& patch) {
  clear(patch);
  for (const int v : vertices)
    mesh::visit_corners(s, v, [&](int c) { patch.replaced.push_back(c / 3); });
  sort_unique(patch.replaced);
  for (const int t : patch.replaced) patch.facets.push_back(named_facet(s, t));
}

void take_collapsed(const mesh::Surface& s, int keep, int gone, const Vec3& x_W, Patch& patch) {
  take_stars(s, {keep, gone}, patch);
  std::erase_if(patch.facets,
                [&](const NamedFacet& f) { return has(f.names, keep) && has(f.names, gone); });
  for (NamedFacet& f : patch.facets) {
    rename(f, keep, keep, x_W);
    rename(f, gone, keep, x_W);
  }
}

void find_intersections(const Rock& rock, const Patch& patch, double longest_edge, std::size_t most,
                        IntersectionWork& work) {
  work.met.clear();
  if (patch.facets.empty()) return;
  find_near(rock, patch, longest_edge, work);
  const auto note = [&](const NamedFacet& f, const mesh::Box& box, const NamedFacet& other) {
    if (work.met.size() < most && box_of(other).overlaps(box) && mesh::intersect(f, other))
      work.met.emplace_back(f.names, other.names);
  };
  for (std::size_t i = 0; i < patch.facets.size() && work.met.size() < most; ++i) {
    const NamedFacet& f = patch.facets[i];
    const mesh::Box box = box_of(f);
    for (std::size_t k = 0; k < i; ++k) note(f, box, patch.facets[k]);
    for (const int t : work.triangles) note(f, box, named_facet(rock.surface, t));
  }
}

}  // namespace tdbd::rock
