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

/// Renames corner `from` of a facet to `to` and moves it to x_W.
void rename(NamedFacet& f, int from, int to, const Vec3& x_W) {
  for (std::size_t i = 0; i < 3; ++i)
    if (f.names[i] == from) {
      f.names[i] = to;
      f.x[i] = x_W;
    }
}

/// Whether all corners of the other facet that f does not share lie on one side of the plane of f,
/// at a distance well above rounding. Then the facets meet at most in what they share.
bool is_beyond_plane(const NamedFacet& f, const NamedFacet& other) {
  constexpr double far_from_rounding = 1e-9;
  const Vec3 ab = f.x[1] - f.x[0], ac = f.x[2] - f.x[0], n = ab.cross(ac);
  const double size = ab.cwiseAbs().sum() + ac.cwiseAbs().sum();
  const double slack = far_from_rounding * size * size * size;
  int apart = 0, above = 0, below = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (has(f.names, other.names[i])) continue;
    const double d = n.dot(other.x[i] - f.x[0]);
    ++apart;
    above += d > slack ? 1 : 0;
    below += d < -slack ? 1 : 0;
  }
  return apart > 0 && (above == apart || below == apart);
}

bool are_surely_apart(const NamedFacet& f, const NamedFacet& g) {
  return is_beyond_plane(f, g) || is_beyond_plane(g, f);
}

/// Whether the box of triangle t overlaps another box; same criterion as Box::overlaps.
bool is_near(const mesh::Surface& s, int t, const mesh::Box& box) {
  const mesh::Triangle& v = s.triangles[at(t)];
  const Vec3 &a = s.position(v[0]), &b = s.position(v[1]), &c = s.position(v[2]);
  for (int k = 0; k < 3; ++k) {
    if (a[k] > box.hi[k] && b[k] > box.hi[k] && c[k] > box.hi[k]) return false;
    if (a[k] < box.lo[k] && b[k] < box.lo[k] && c[k] < box.lo[k]) return false;
  }
  return true;
}

/// Whether a vertex of the index, rounded to single precision, is in the box.
bool is_inside(const VertexGrid::Block& block, std::size_t i, const mesh::Box& box) {
  return block.x[i] >= box.lo.x() && block.x[i] <= box.hi.x() && block.y[i] >= box.lo.y() &&
         block.y[i] <= box.hi.y() && block.z[i] >= box.lo.z() && block.z[i] <= box.hi.z();
}

/// Finds the triangles of the surface that remain and may meet the patch, by boxes and nearest
/// vertices.
void find_near(const Rock& rock, const Patch& patch, double longest_edge, IntersectionWork& work) {
  constexpr double circumradius = 0.6;  // of an equilateral triangle over its edge; rounded up
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
  mesh::Box rounded = region.box;
  constexpr double single_rounding = 1e-6;  // relative, rounded up
  const double slack = single_rounding *
                       std::max(rounded.lo.cwiseAbs().maxCoeff(), rounded.hi.cwiseAbs().maxCoeff());
  rounded.lo.array() -= slack;
  rounded.hi.array() += slack;
  rock.grid.visit(region, work.chains, [&](const VertexGrid::Block& block) {
    for (std::size_t i = 0; i < at(block.count); ++i) {
      if (!is_inside(block, i, rounded)) continue;
      mesh::visit_corners(s, block.v[i], [&](int c) {
        const int t = c / 3;
        if (work.seen[at(t)] == work.stamp) return;
        work.seen[at(t)] = work.stamp;
        if (is_near(s, t, patch_box)) work.triangles.push_back(t);
      });
    }
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
  const auto note = [&](const NamedFacet& f, const NamedFacet& other) {
    if (work.met.size() < most && !are_surely_apart(f, other) && mesh::intersect(f, other))
      work.met.emplace_back(f.names, other.names);
  };
  for (std::size_t i = 0; i < patch.facets.size() && work.met.size() < most; ++i) {
    const NamedFacet& f = patch.facets[i];
    const mesh::Box box = box_of(f);
    for (std::size_t k = 0; k < i; ++k)
      if (box_of(patch.facets[k]).overlaps(box)) note(f, patch.facets[k]);
    for (const int t : work.triangles)
      if (is_near(rock.surface, t, box)) note(f, named_facet(rock.surface, t));
  }
}

}  // namespace tdbd::rock
